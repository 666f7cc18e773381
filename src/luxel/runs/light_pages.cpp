// SPDX-License-Identifier: Apache-2.0
#include "luxel/runs/light_pages.h"

#include <numeric>

#include <fmt/format.h>

#include "luxel/export/round_trip_layout.h"
#include "luxel/render/new_layout.h"

namespace luxel {
namespace {

// A layout that leaves pages mostly empty is not worth its memory.
constexpr double many_texels = 0x1p24;
constexpr double max_texels_per_surface_texel = 64.0;

// Returns the file's own texture layout, if it is requested and usable.
std::optional<LaidOut> layout_of_file(const PagesInput& input, const LightmapSettings& settings,
                                      const Context& context, Reporter& reporter) {
  if (!input.scene || settings.layout == "new") return std::nullopt;
  const auto& scene = *input.scene;
  std::string why;
  const auto given = round_trip_layout(scene, input.patches, input.metres_per_unit, why);
  int size = 0;
  if (given) {
    const auto texels = texels_per_metre(input.patches, input.solution, settings.lightmap);
    size = page_size_for(scene, *given, texels, settings.lightmap.page_size);
    const auto area = std::accumulate(input.patches.area.begin(), input.patches.area.end(), 0.0);
    if (const auto all = static_cast<double>(given->pages) * size * size;
        all > max_texels_of_pages ||
        (all > many_texels && all > max_texels_per_surface_texel * texels * texels * area))
      why = fmt::format(
          "their {} pages of {} x {} texels would be {:.0f} million for {:.2g} million of surfaces",
          given->pages, size, size, 1e-6 * all, 1e-6 * texels * texels * area);
  }
  if (!why.empty())
    warn(reporter.log(), fmt::format("{}: the file's {} are not used, charts are made: {}", scene.source,
                                     lightmap_coordinates, why));
  if (!given || !why.empty()) return std::nullopt;
  reporter.detail("pages", fmt::format("{} are used as the file has them, on {} page{}", lightmap_coordinates,
                                       given->pages, given->pages == 1 ? "" : "s"));
  return lay_out(scene, input.patches, *given,
                 {settings.lightmap.crease_angle, size, settings.lightmap.margin}, context);
}

}  // namespace

std::optional<LightPages> make_light_pages(const PagesInput& input, const LightmapSettings& settings,
                                           const Tracer* tracer, const Context& context, Reporter& reporter,
                                           const TimeBudget* budget) {
  const auto& options = settings.lightmap;
  const bool interrupted_before = reporter.is_interrupted();
  reporter.announce("charts");
  auto laid = layout_of_file(input, settings, context, reporter);
  const bool as_file_has_it = laid.has_value();
  if (!laid)
    laid = lay_out(input.patches, input.solution, options, reporter.reporting(context, !interrupted_before));
  if (!interrupted_before && reporter.is_interrupted()) return std::nullopt;

  LightPages made;
  auto& record = made.record;
  // After an earlier interrupt there is no time to gather, but pages are still required.
  const auto monitor = [heeding = reporter.monitor(), interrupted_before, budget](const Progress& progress) {
    const auto next = heeding(progress);
    if (progress.stage == "texels" && budget && budget->is_over()) return Next::stop;
    return interrupted_before && progress.stage != "texels" ? Next::go_on : next;
  };
  made.lightmap = fill_lightmap({input.patches, input.solution, tracer}, *laid, options, &record.made,
                                context.with_monitor(monitor));
  if (made.lightmap.pages.empty()) return std::nullopt;
  record.pages = made.lightmap.atlas.pages;
  record.page_size = made.lightmap.atlas.page_size;
  record.as_file_has_it = as_file_has_it;
  record.error_target = tracer ? options.texels.error : 0.0;
  reporter.clear_bar();
  reporter.say("pages", describe(made.lightmap, record.made));
  if (record.made.texels.stopped)
    warn(reporter.log(), "stopped: texels that were not gathered yet have the light between patches");
  return made;
}

}  // namespace luxel
