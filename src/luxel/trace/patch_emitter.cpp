// SPDX-License-Identifier: Apache-2.0
#include "luxel/trace/patch_emitter.h"

#include <algorithm>
#include <cassert>

#include "luxel/patch/side.h"

namespace luxel {
namespace {

// Fraction of the way to the centroid by which corners move inwards so that every point is `margin` off each
// edge. The centroid is a third of a height away from each edge, and the smallest height is 2 area / longest
// edge.
float draw_in(const std::array<Vec3, 3>& p, float area, float margin) {
  const auto longest =
      std::max({glm::distance(p[0], p[1]), glm::distance(p[1], p[2]), glm::distance(p[2], p[0])});
  const auto third_height = 2.0f * area / (3.0f * longest);
  return std::min(0.25f, margin / third_height);
}

}  // namespace

PatchEmitter::PatchEmitter(const PatchSet& patches, SideId side) : frame_(patches.normal_of(side)) {
  assert(side && side.patch() < patches.size());
  auto p = patches.points(side.patch());
  const auto lift = origin_lift(p);
  const auto fraction = draw_in(p, patches.area[side.patch()], 2.0f * lift);
  const auto centroid = (p[0] + p[1] + p[2]) / 3.0f;
  for (auto& corner : p) corner += fraction * (centroid - corner) + lift * frame_.n;
  base_ = p[0];
  edge_b_ = p[1] - p[0];
  edge_c_ = p[2] - p[0];
}

}  // namespace luxel
