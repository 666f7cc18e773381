// SPDX-License-Identifier: Apache-2.0
#include "luxel/lamps/shadow_test.h"

#include <algorithm>

#include "luxel/trace/point_sight.h"

namespace luxel {
namespace {

constexpr double min_lift = 4.0;         // of ray origins, in multiples of the rounding bound
constexpr double inside_fraction = 0.9;  // of the distance to the boundary of the triangle, at most
constexpr double nearest_reach = 0.05;   // of reach: points that are nearer to the line show nothing
constexpr double fine_fraction = 0.1;    // of reach: the second pair, where light or shadow is narrow
constexpr double on_edge_reach = 3.0;    // in reach: a line that was moved is off by up to twice `reach`

}  // namespace

ShadowTest::ShadowTest(const PatchSet& triangles, const Tracer& tracer, const EdgeShadow& shadow,
                       double reach)
    : shadow_(shadow),
      light_(triangles.point_lights[shadow.light].light),
      tracer_(tracer),
      plane_(triangles.points(shadow.triangle)),
      lift_(min_lift * static_cast<double>(origin_lift(triangles.points(shadow.triangle)))),
      reach_(shadow.on_edge ? on_edge_reach * reach : reach) {
  const auto across = glm::normalize(glm::cross(plane_.normal, shadow.ends[1] - shadow.ends[0]));
  outer_ = glm::dot(across, shadow.outward) > 0.0 ? across : -across;
}

bool ShadowTest::divides(double fraction) const {
  const auto at = shadow_.ends[0] + fraction * (shadow_.ends[1] - shadow_.ends[0]);
  return divides_at(at, reach_) || divides_at(at, fine_fraction * reach_);
}

bool ShadowTest::divides_at(const Vec3d& at, double reach) const {
  auto out = reach, in = reach;
  if (!shadow_.on_edge) {
    out = std::min(out, inside_fraction * distance_inside(at, outer_));
    in = std::min(in, inside_fraction * distance_inside(at, -outer_));
    if (std::min(out, in) < nearest_reach * reach_) return false;
  }
  return is_lit(at + out * outer_) && !is_lit(at - in * outer_);
}

// The distance to the boundary of the triangle, m.
double ShadowTest::distance_inside(const Vec3d& from, const Vec3d& way) const {
  auto distance = 2.0 * reach_;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto approach = -glm::dot(plane_.inward[k], way);
    if (approach > 0.0) distance = std::min(distance, std::max(0.0, plane_.inside(k, from)) / approach);
  }
  return distance;
}

bool ShadowTest::is_lit(const Vec3d& point) const {
  const auto origin = point + lift_ * shadow_.lit_side;
  const auto sight = sight_of(light_, origin, shadow_.lit_side);
  return sight.irradiance > 0.0 && !tracer_.occluded({Vec3(origin), Vec3(sight.direction)}, sight.distance);
}

}  // namespace luxel
