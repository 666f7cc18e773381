// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/core/warp.h"
#include "luxel/patch/patch_set.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// Side 2 * patch is the front, 2 * patch + 1 the back.
inline Vec3 side_normal(const PatchSet& patches, std::size_t side) {
  return side % 2 == 0 ? patches.normal[side / 2] : -patches.normal[side / 2];
}

// A uniform point of the side, lifted off it.
inline Vec3 point_before(const PatchSet& patches, std::size_t side, float u1, float u2) {
  const auto points = patches.points(side / 2);
  const auto where = uniform_triangle(u1, u2);
  return (1.0f - where.x - where.y) * points[0] + where.x * points[1] + where.y * points[2] +
         2.0f * origin_lift(points) * side_normal(patches, side);
}

}  // namespace luxel
