// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/surface_point.h"

#include <algorithm>

#include "luxel/trace/tracer.h"

namespace luxel {

SurfacePoint surface_point(const PatchSet& patches, std::size_t patch, bool back, const Vec2& weights) {
  constexpr float max_drawn_in =
      0.25f;  // fraction of the distance to the centroid; limits slivers as thin as the lift
  const auto corners = patches.points(patch);
  const auto b = corners[1] - corners[0];
  const auto c = corners[2] - corners[0];
  const auto lift = origin_lift(corners);
  // The centroid is at a third of the height from each edge, and the smallest height is 2 area / longest
  // edge.
  const auto longest = std::max({glm::length(b), glm::length(c), glm::length(c - b)});
  const auto third_height = 2.0f * patches.area[patch] / (3.0f * longest);
  const auto drawn_in = std::min(max_drawn_in, 2.0f * lift / third_height);

  SurfacePoint point;
  point.patch = static_cast<std::uint32_t>(patch);
  point.back = back;
  point.normal = back ? -patches.normal[patch] : patches.normal[patch];
  const auto w = weights + drawn_in * (Vec2(1.0f / 3.0f) - weights);
  point.position = corners[0] + w.x * b + w.y * c + lift * point.normal;
  return point;
}

}  // namespace luxel
