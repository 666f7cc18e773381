// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "luxel/core/warp.h"
#include "luxel/patch/patch_set.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// Whether the side that was met sends light on.
inline bool reflects(const PatchSet& patches, const Hit& hit) {
  const auto& material = patches.material_of(hit.patch);
  if (hit.back && !material.two_sided) return false;
  for (const auto r : material.reflectance)
    if (r > 0.0f) return true;
  return false;
}

// A cosine ray from a point of a patch's side, given by the weights of its corners b and c. The point keeps a
// thousandth of the way to the centroid off the edges, and is lifted off the surface, so that rounding takes
// no ray through a wall.
inline Ray bounce(const PatchSet& patches, std::size_t patch, bool back, const Vec2& weights, float u1,
                  float u2) {
  constexpr float inwards = 1e-3f;
  const auto p = patches.points(patch);
  const auto normal = back ? -patches.normal[patch] : patches.normal[patch];
  auto at = p[0] + weights.x * (p[1] - p[0]) + weights.y * (p[2] - p[0]);
  at += inwards * ((p[0] + p[1] + p[2]) / 3.0f - at) + origin_lift(p) * normal;
  return {at, Frame(normal).to_world(cosine_hemisphere(u1, u2))};
}

}  // namespace luxel
