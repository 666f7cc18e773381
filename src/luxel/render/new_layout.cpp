// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/new_layout.h"

#include <algorithm>
#include <cmath>

#include "luxel/surface/make_charts.h"
#include "luxel/surface/pack_charts.h"

namespace luxel {

namespace {

// The texel of an automatic density where there are so many charts that most would be a few texels: their
// borders and margins would then be the larger part of the pages. No smaller than the longest chart allows.
float texel_for_charts(const PatchSet& patches, const Charts& charts, const PackOptions& pack) {
  constexpr double texels_per_chart = 40.0;
  double area = 0.0, longest = 0.0;  // m², m
  for (const auto& chart : charts.charts) {
    for (const auto side : chart.sides)
      if (!chart.is_point) area += static_cast<double>(patches.area[side.patch()]);
    longest = std::max(longest, chart.stretch * chart.size[0]);
  }
  const auto wanted = texels_per_chart * static_cast<double>(charts.charts.size());
  const auto texel = std::max(std::sqrt(area / wanted), longest / max_texels(pack));
  return std::min(pack.texel, static_cast<float>(texel));
}

}  // namespace

LaidOut lay_out(const PatchSet& patches, const Solution& solution, const LightmapOptions& options,
                const Context& context) {
  PackOptions pack{.texel = static_cast<float>(1.0 / texels_per_metre(patches, solution, options)),
                   .page_size = options.page_size,
                   .margin = options.margin};
  check_pack_options(patches, pack);
  LaidOut laid;
  laid.charts = make_charts(
      patches, solution,
      {.texel = pack.texel, .crease_angle = options.crease_angle, .max_texels = max_texels(pack)}, context);
  if (laid.charts.charts.empty()) return {};
  if (!options.texels_per_metre) pack.texel = texel_for_charts(patches, laid.charts, pack);
  laid.atlas = pack_charts(patches, laid.charts, pack);
  return laid;
}

}  // namespace luxel
