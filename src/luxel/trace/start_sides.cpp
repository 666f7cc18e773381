// SPDX-License-Identifier: Apache-2.0
#include "luxel/trace/start_sides.h"

#include <algorithm>
#include <numeric>

#include "luxel/core/warp.h"

namespace luxel {

StartSides::StartSides(const PatchSet& patches, const std::vector<std::uint8_t>& may_start)
    : patches_(patches), sum_(patches.size()) {
  const auto triangles = patches.triangle.empty()
                             ? 0u
                             : *std::max_element(patches.triangle.begin(), patches.triangle.end()) + 1u;
  std::vector<double> area_of(triangles, 0.0);
  for (std::size_t p = 0; p < patches.size(); ++p)
    area_of[patches.triangle[p]] += static_cast<double>(patches.area[p]);
  const auto whole = std::max(1e-300, std::accumulate(area_of.begin(), area_of.end(), 0.0));
  const auto count = static_cast<double>(std::max(1u, triangles));
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const auto area = static_cast<double>(patches.area[p]);
    const auto of_triangle = std::max(1e-300, area_of[patches.triangle[p]]);
    if (may_start.empty() || may_start[p] != 0) total_ += area / whole + area / of_triangle / count;
    sum_[p] = total_;
  }
}

std::uint32_t StartSides::pick(float u) const {
  const auto at = static_cast<double>(u) * total_;
  const auto found = std::upper_bound(sum_.begin(), sum_.end(), at);
  const auto patch = static_cast<std::uint32_t>(
      std::min<std::ptrdiff_t>(found - sum_.begin(), static_cast<std::ptrdiff_t>(sum_.size()) - 1));
  if (!patches_.material_of(patch).two_sided) return 2 * patch;
  const auto before = patch == 0 ? 0.0 : sum_[patch - 1];
  return 2 * patch + (at - before > 0.5 * (sum_[patch] - before) ? 1u : 0u);
}

Ray ray_from_side(const PatchSet& patches, std::uint32_t side, const std::array<float, 4>& u) {
  constexpr float inwards = 1e-3f;  // of the way to the centroid: rounding takes no ray through a wall
  const auto patch = side / 2;
  const auto p = patches.points(patch);
  const auto normal = side % 2 == 1 ? -patches.normal[patch] : patches.normal[patch];
  const auto at_triangle = uniform_triangle(u[0], u[1]);
  auto at = p[0] + at_triangle.x * (p[1] - p[0]) + at_triangle.y * (p[2] - p[0]);
  at += inwards * ((p[0] + p[1] + p[2]) / 3.0f - at) + origin_lift(p) * normal;
  return {at, Frame(normal).to_world(cosine_hemisphere(u[2], u[3]))};
}

}  // namespace luxel
