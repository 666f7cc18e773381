// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/core/warp.h"
#include "luxel/patch/patch_set.h"
#include "luxel/patch/side.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// A uniform point of the side, lifted off it.
inline Vec3 point_before(const PatchSet& patches, SideId side, float u1, float u2) {
  const auto points = patches.points(side.patch());
  const auto where = uniform_triangle(u1, u2);
  return (1.0f - where.x - where.y) * points[0] + where.x * points[1] + where.y * points[2] +
         2.0f * origin_lift(points) * patches.normal_of(side);
}

}  // namespace luxel
