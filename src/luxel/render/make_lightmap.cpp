// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/make_lightmap.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/render/dilate.h"
#include "luxel/render/new_layout.h"
#include "luxel/solution/back_is_lit.h"
#include "luxel/surface/smooth_light.h"

namespace luxel {
namespace {

// So that the sides with light have half of the texels of a page.
double automatic_texels(const PatchSet& patches, const Solution& solution, int page_size) {
  constexpr int max_of_page = 512;
  constexpr double fraction = 0.5;
  double area = 0.0;  // m²
  for (std::size_t p = 0; p < patches.size(); ++p)
    area += (back_is_lit(solution, p) ? 2.0 : 1.0) * patches.area[p];
  const double side = std::min(page_size, max_of_page);
  return std::sqrt(fraction * side * side / area);
}

}  // namespace

double texels_per_metre(const PatchSet& patches, const Solution& solution, const LightmapOptions& options) {
  const auto texels = options.texels_per_metre ? *options.texels_per_metre
                                               : automatic_texels(patches, solution, options.page_size);
  if (!(texels > 0.0) || !std::isfinite(texels))
    throw InputError(fmt::format("the texels a metre must be more than 0, but they are {}", texels));
  return texels;
}

Lightmap fill_lightmap(const PatchSet& patches, const Solution& solution, const Tracer* tracer,
                       const LaidOut& laid, const LightmapOptions& options, const Workers& workers,
                       LightmapReport* report, const Monitor& monitor) {
  const auto smooth = make_smooth_light(patches, solution, {.crease_angle = options.crease_angle}, workers);
  Lightmap lightmap;
  LightmapReport done;
  done.charts = laid.charts.charts.size();
  lightmap.atlas = laid.atlas;
  done.texels = gather_texels(patches, solution, smooth, tracer, options.texels, workers, lightmap, monitor);
  if (lightmap.pages.empty()) return lightmap;
  const Monitor none;
  const auto& rest = done.texels.stopped ? none : monitor;
  done.seams = solve_seams(laid.charts, lightmap, {}, rest);
  if (done.seams.stopped || !dilate(lightmap, options.margin, rest)) lightmap.pages.clear();
  if (report) *report = done;
  return lightmap;
}

Lightmap make_lightmap(const PatchSet& patches, const Solution& solution, const Tracer* tracer,
                       const LightmapOptions& options, const Workers& workers, LightmapReport* report,
                       const Monitor& monitor) {
  const auto laid = lay_out(patches, solution, options, workers, monitor);
  if (laid.charts.charts.empty()) return {};
  return fill_lightmap(patches, solution, tracer, laid, options, workers, report, monitor);
}

}  // namespace luxel
