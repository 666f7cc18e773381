// SPDX-License-Identifier: Apache-2.0
#include "luxel/runs/lightmap_settings.h"

#include <fmt/format.h>

#include "luxel/runs/compression_setting.h"
#include "luxel/runs/quantity.h"
#include "luxel/surface/pack_charts.h"

namespace luxel {
namespace {

double parse_gather(const std::string& text) {
  if (text == "none") return 0.0;
  if (const auto fraction = parse_fraction(text); fraction && *fraction > 0.0) return *fraction;
  throw UsageError(fmt::format(
      "--final-gather: expected none or a fraction above 0 and below 1, such as 2% or 0.02, not '{}'", text));
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
      "layout of the atlas; file: the second texture coordinates of the file, where usable; new: new charts");
}

void LightmapSettings::declare_pages(OptionSet& set) {
  set.add({"texels-per-metre", "1/m",
           "minimum texel density of surfaces; auto: the one that covers 131,000 texels, or 40 per chart",
           [this](const std::string& text) { lightmap.texels_per_metre = parse_texels(text); },
           [this] {
             return lightmap.texels_per_metre ? fmt::format("{}", *lightmap.texels_per_metre)
                                              : std::string("auto");
           }});
  set.add_number("page-size", "texels", lightmap.page_size, 8, 16384,
                 "maximum width and height of an atlas page; more pages are added as needed");
  set.add_number("margin", "texels", lightmap.margin, 0, 64,
                 "margin around charts and at page edges, filled by dilation");
}

void LightmapSettings::declare_texels(OptionSet& set) {
  auto& texels = lightmap.texels;
  set.add(
      {"final-gather", "fraction",
       "per-texel final gather to this standard error, relative to the texel's irradiance, where patches are "
       "too coarse; none disables it",
       [&texels](const std::string& text) { texels.error = parse_gather(text); },
       [&texels] { return texels.error == 0.0 ? std::string("none") : as_fraction(texels.error); }});
  set.add_number("gather-rays", "count", texels.max_rays, 64u, 1u << 20,
                 "maximum number of cosine rays per texel of the final gather, and as many shadow rays");
}

void LightmapSettings::declare(OptionSet& set) {
  set.heading("Pages");
  declare_pages(set);
  set.add_number("crease-angle", "degrees", lightmap.crease_angle, 0.0f, 180.0f,
                 "maximum angle between neighbours in one chart");
  set.heading("Texels");
  declare_texels(set);
  set.add_count("seed", lightmap.texels.seed, "seed of the final gather");
  set.heading("Files");
  set.add({"png-white", "W/m²",
           "irradiance shown as white in PNG files; auto: the 99.9th percentile of lit texels",
           [this](const std::string& text) { white = parse_white(text); },
           [this] { return white == automatic_white ? std::string("auto") : fmt::format("{}", white); }});
  set.add_output("error-map", error_map, "EXR file for the standard error of each texel, W/m²");
  set.add_output(
      "directional", directional,
      "EXR files for the light vector in W/m², for surfaces with normal maps: room.exr becomes room-x.exr, "
      "room-y.exr and room-z.exr");
  set.add_output(
      "uv2", unwrapped,
      "the scene with the lightmap coordinates: .glb, as TEXCOORD_1 beside its own; .obj, which has one "
      "set, as vt instead of its own");
  declare_compression(set, compression, "the .glb of --uv2");
  set.add_output("preview", preview, "picture (.png .exr .hdr) of the scene drawn with the lightmap");
}

void LightmapSettings::check_texels(const PatchSet& patches) const {
  if (!lightmap.texels_per_metre) return;
  check_pack_options(patches, {.texel = static_cast<float>(1.0 / *lightmap.texels_per_metre),
                               .page_size = lightmap.page_size,
                               .margin = lightmap.margin});
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
