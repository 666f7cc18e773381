// SPDX-License-Identifier: Apache-2.0
#include "luxel/transport/lamp_sample.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "luxel/random/spherical_triangle.h"

namespace luxel {
namespace {

constexpr double far_away = 10.0;  // longest edges from the centroid

}  // namespace

LampSample sample_lamp(const LampTriangle& lamp, const Vec3d& x, double u1, double u2) {
  const std::array<Vec3d, 3> corner = {Vec3d(lamp.corner[0]) - x, Vec3d(lamp.corner[1]) - x,
                                       Vec3d(lamp.corner[2]) - x};
  const auto before = -glm::dot(lamp.normal, corner[0]);  // height of x over the lamp's plane
  if (!(before > 0.0)) return {};
  const auto three_centroids = corner[0] + corner[1] + corner[2];
  const auto reach = 3.0 * far_away * lamp.longest_edge;
  if (glm::dot(three_centroids, three_centroids) > reach * reach) {
    const auto root = std::sqrt(u1);
    const auto point =
        corner[0] + ((1.0 - u2) * root) * (corner[1] - corner[0]) + (u2 * root) * (corner[2] - corner[0]);
    const auto distance = glm::length(point);
    return {point / distance, distance, distance * distance * distance / (before * lamp.area)};
  }
  const SphericalTriangle seen(corner);
  if (!(seen.solid_angle() > 0.0)) return {};
  const auto direction = seen.direction(u1, u2);
  // Towards the horizon of the lamp the quotient loses its digits; no point is farther than a corner.
  const auto farthest = std::max({glm::length(corner[0]), glm::length(corner[1]), glm::length(corner[2])});
  const auto down = -glm::dot(lamp.normal, direction);
  const auto distance = down * farthest > before ? before / down : farthest;
  return {direction, distance, seen.density()};
}

}  // namespace luxel
