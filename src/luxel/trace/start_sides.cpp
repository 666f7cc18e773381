// SPDX-License-Identifier: Apache-2.0
#include "luxel/trace/start_sides.h"

#include <algorithm>
#include <numeric>

#include "luxel/core/warp.h"
#include "luxel/patch/side.h"

namespace luxel {

StartSides::StartSides(const PatchSet& patches, const std::vector<std::uint8_t>& may_start)
    : patches_(patches) {
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
    const bool may = may_start.empty() || may_start[p] != 0;
    by_weight_.add(may ? area / whole + area / of_triangle / count : 0.0);
  }
}

SideId StartSides::pick(float u) const {
  const auto at = static_cast<double>(u) * by_weight_.total();
  const auto patch = static_cast<std::uint32_t>(by_weight_.at(at));
  if (!patches_.material_of(patch).two_sided) return {patch, false};
  return {patch, at - by_weight_.before(patch) > 0.5 * by_weight_.weight(patch)};
}

Ray ray_from_side(const PatchSet& patches, SideId side, const Vec2& weights, float u1, float u2) {
  constexpr float inwards = 1e-3f;  // of the way to the centroid
  const auto p = patches.points(side.patch());
  const auto normal = patches.normal_of(side);
  auto at = p[0] + weights.x * (p[1] - p[0]) + weights.y * (p[2] - p[0]);
  at += inwards * ((p[0] + p[1] + p[2]) / 3.0f - at) + origin_lift(p) * normal;
  return {at, Frame(normal).to_world(cosine_hemisphere(u1, u2))};
}

Ray ray_from_side(const PatchSet& patches, SideId side, const std::array<float, 4>& u) {
  return ray_from_side(patches, side, uniform_triangle(u[0], u[1]), u[2], u[3]);
}

}  // namespace luxel
