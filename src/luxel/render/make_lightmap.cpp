// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/make_lightmap.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/render/dilate.h"
#include "luxel/render/gather_texels.h"
#include "luxel/render/new_layout.h"
#include "luxel/render/solve_seams.h"
#include "luxel/solution/back_is_lit.h"
#include "luxel/surface/smooth_light.h"

namespace luxel {
namespace {

// Texel size for which the lit sides cover half of a page.
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
    throw InputError(fmt::format("texels per metre: expected a positive number, found {}", texels));
  return texels;
}

Lightmap fill_lightmap(const LightmapInput& input, const LaidOut& laid, const LightmapOptions& options,
                       LightmapReport* report, const Context& context) {
  const auto smooth =
      make_smooth_light(input.patches, input.solution, {.crease_angle = options.crease_angle}, context);
  Lightmap lightmap;
  LightmapReport done;
  done.charts = laid.charts.charts.size();
  lightmap.atlas = laid.atlas;
  done.texels = gather_texels(input, smooth, options.texels, lightmap, context);
  if (lightmap.pages.empty()) return lightmap;
  const auto rest = done.texels.stopped ? context.quiet() : context;
  done.seams = solve_seams(laid.charts, lightmap, {}, rest);
  if (done.seams.stopped || !dilate(lightmap, options.margin, rest)) lightmap.pages.clear();
  if (report) *report = done;
  return lightmap;
}

Lightmap make_lightmap(const LightmapInput& input, const LightmapOptions& options, LightmapReport* report,
                       const Context& context) {
  const auto laid = lay_out(input.patches, input.solution, options, context);
  if (laid.charts.charts.empty()) return {};
  return fill_lightmap(input, laid, options, report, context);
}

}  // namespace luxel
