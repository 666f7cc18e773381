// SPDX-License-Identifier: Apache-2.0
#include "luxel/lamps/outer_back.h"

#include "luxel/core/warp.h"

namespace luxel {
namespace {

constexpr int strata = 4;         // in both directions of the hemisphere
constexpr float min_lift = 4.0f;  // of ray origins, in multiples of the rounding bound

// The number of cosine-distributed rays, of strata², that leave the scene.
int rays_that_leave(const Tracer& tracer, const Vec3& origin, const Vec3& normal) {
  int leave = 0;
  for (int i = 0; i < strata * strata; ++i) {
    const auto u = (static_cast<float>(i % strata) + 0.5f) / strata;
    const auto v = (static_cast<float>(i / strata) + 0.5f) / strata;
    if (!tracer.nearest({origin, Frame(normal).to_world(cosine_hemisphere(u, v))})) ++leave;
  }
  return leave;
}

}  // namespace

bool is_on_outer_back(const PatchSet& triangles, const Tracer& tracer, const EdgeShadow& shadow) {
  const auto front = triangles.normal[shadow.triangle];
  const Vec3 lit(shadow.lit_side);
  if (glm::dot(lit, front) > 0.0f) return false;
  const Vec3 middle(0.5 * (shadow.ends[0] + shadow.ends[1]));
  const auto lift = min_lift * origin_lift(triangles.points(shadow.triangle));
  constexpr int half = strata * strata / 2;
  return rays_that_leave(tracer, middle + lift * lit, lit) > half &&
         rays_that_leave(tracer, middle - lift * lit, -lit) < half;
}

}  // namespace luxel
