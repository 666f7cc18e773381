// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/lightmap_settings.h"

#include <fmt/format.h>

#include "luxel/cli/quantity.h"

namespace luxel {
namespace {

double parse_gather(const std::string& text) {
  if (text == "none") return 0.0;
  if (const auto share = parse_share(text); share && *share > 0.0) return *share;
  throw UsageError(fmt::format(
      "--final-gather: expected none or a share above 0 and below 1, such as 2% or 0.02, not '{}'", text));
}

std::optional<double> parse_texels(const std::string& text) {
  if (text == "auto") return std::nullopt;
  if (const auto number = parse_double(text); number && *number >= 1e-6 && *number <= 1e6) return *number;
  throw UsageError(fmt::format("--texels-per-metre: expected auto or 1e-6 to 1e6, not '{}'", text));
}

double parse_white(const std::string& text) {
  if (text == "auto") return LightmapSettings::automatic_white;
  if (const auto number = parse_double(text); number && *number > 0.0 && *number < 1e9) return *number;
  throw UsageError(fmt::format("--png-white: expected auto or W/m² above 0, not '{}'", text));
}

}  // namespace

void LightmapSettings::declare_layout(OptionSet& set) {
  set.add_choice(
      "layout", {"file", "new"}, layout,
      "where surfaces lie on pages: as the file's second texture coordinates say, if they can be used, "
      "or in new charts");
}

void LightmapSettings::declare_pages(OptionSet& set) {
  set.add({"texels-per-metre", "1/m",
           "texels along a metre of a surface, at least; auto: as many as fill half of a page of 512 x 512",
           [this](const std::string& text) { lightmap.texels_per_metre = parse_texels(text); },
           [this] {
             return lightmap.texels_per_metre ? fmt::format("{}", *lightmap.texels_per_metre)
                                              : std::string("auto");
           }});
  set.add_number("page", "texels", lightmap.page_size, 8, 16384,
                 "largest width and height of a page; what does not fit goes on further ones");
  set.add_number("margin", "texels", lightmap.margin, 0, 64,
                 "between charts, and at the edge of a page; filled with the light beside");
}

void LightmapSettings::declare_texels(OptionSet& set) {
  auto& texels = lightmap.texels;
  set.add(
      {"final-gather", "share",
       "gather light anew where patches are too coarse, until a texel's standard error, relative to its own "
       "irradiance, is this; 'none' disables it",
       [&texels](const std::string& text) { texels.error = parse_gather(text); },
       [&texels] { return texels.error == 0.0 ? std::string("none") : as_share(texels.error); }});
  set.add_number("gather-rays", "count", texels.most_rays, 64u, 1u << 20,
                 "cosine rays that a texel may take for that, and as many to lamps");
}

void LightmapSettings::declare(OptionSet& set) {
  set.heading("Pages");
  declare_pages(set);
  set.add_number("crease-angle", "degrees", lightmap.crease_angle, 0.0f, 180.0f,
                 "neighbours that meet at a sharper angle are different surfaces");
  set.heading("Texels");
  declare_texels(set);
  set.add_count("seed", lightmap.texels.seed, "of the gather's rays");
  set.heading("Files");
  set.add({"png-white", "W/m²",
           "irradiance that a PNG shows as white; auto: what 999 of 1000 lit texels stay below",
           [this](const std::string& text) { white = parse_white(text); },
           [this] { return white == automatic_white ? std::string("auto") : fmt::format("{}", white); }});
  set.add_text("error-map", "FILE", error_map,
               "an EXR file for the standard error of each texel, W/m², in the same places");
  set.add_text(
      "directional", "FILE", directional,
      "EXR files for where light comes from, for surfaces with normal maps: room.exr becomes room-x.exr, "
      "room-y.exr and room-z.exr, the light vector in W/m²");
  set.add_text("preview", "FILE", preview,
               "a picture (.png .exr .hdr) of the scene as a reader of the pages sees it");
}

std::string describe(const Lightmap& lightmap, const LightmapReport& report) {
  const auto& texels = report.texels;
  auto text = fmt::format("{} charts on {} page{} of {} x {} texels; {} texels with light of their own",
                          report.charts, lightmap.atlas.pages, lightmap.atlas.pages == 1 ? "" : "s",
                          lightmap.atlas.page_size, lightmap.atlas.page_size, texels.texels);
  if (texels.gathered > 0)
    text += fmt::format(", {} of them gathered with {} rays", texels.gathered, texels.rays);
  if (texels.short_of_it > 0) text += fmt::format(" ({} with a larger error than asked)", texels.short_of_it);
  if (report.seams.places > 0)
    text +=
        fmt::format("\nseams: {} places, difference {:.2g} % before and {:.2g} % after", report.seams.places,
                    100.0 * report.seams.difference_before, 100.0 * report.seams.difference_after);
  return text;
}

}  // namespace luxel
