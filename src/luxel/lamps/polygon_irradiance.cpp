// SPDX-License-Identifier: Apache-2.0
#include "luxel/lamps/polygon_irradiance.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "luxel/core/trig.h"
#include "luxel/core/unit_vector.h"
#include "luxel/lamps/clip_triangle.h"

namespace luxel {
namespace {

// Twice the contribution of the edge from u to v: its arc angle times n · (u x v) / |u x v|.
double edge_term(const Vec3d& u, const Vec3d& v, const Vec3d& n) {
  const auto c = glm::cross(u, v - u);  // u x v without its cancellation
  const auto length = glm::length(c);
  // seen end on, or x lies on the edge, where the limit depends on the direction of approach
  if (!(length > 0.0)) return 0.0;
  return glm::dot(n, c) * (arc_tangent(length, glm::dot(u, v)) / length);
}

}  // namespace

double unit_irradiance(const LampTriangle& lamp, const Vec3d& x, const Vec3d& n) {
  assert(is_unit(n));
  const std::array<Vec3d, 3> corner = {Vec3d(lamp.corner[0]) - x, Vec3d(lamp.corner[1]) - x,
                                       Vec3d(lamp.corner[2]) - x};
  if (glm::dot(lamp.normal, corner[0]) >= 0.0) return 0.0;
  const std::array<double, 3> height = {glm::dot(n, corner[0]), glm::dot(n, corner[1]),
                                        glm::dot(n, corner[2])};
  const auto [low, high] = std::minmax({height[0], height[1], height[2]});
  if (high <= 0.0) return 0.0;
  // Seen from x the polygon is counter-clockwise, so the cross products point away from n: hence the minus.
  double sum = 0.0;
  if (low >= 0.0) {
    sum = edge_term(corner[0], corner[1], n) + edge_term(corner[1], corner[2], n) +
          edge_term(corner[2], corner[0], n);
  } else {
    std::array<Vec3d, 4> above;
    const auto count = static_cast<std::size_t>(clip_triangle(corner, height, above));
    for (std::size_t i = 0; i < count; ++i) sum += edge_term(above[i], above[(i + 1) % count], n);
  }
  return std::max(0.0, -0.5 * sum);
}

double unit_irradiance(std::span<const Vec3d> polygon, const Vec3d& x, const Vec3d& n) {
  assert(is_unit(n));
  if (polygon.size() < 3) return 0.0;
  double sum = 0.0;
  auto u = polygon.back() - x;
  for (const auto& corner : polygon) {
    const auto v = corner - x;
    sum += edge_term(u, v, n);
    u = v;
  }
  return -0.5 * sum;
}

}  // namespace luxel
