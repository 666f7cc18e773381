// SPDX-License-Identifier: Apache-2.0
#include "luxel/lamps/lamp_sample.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "luxel/core/spherical_triangle.h"
#include "luxel/core/unit_vector.h"

namespace luxel {
namespace {

// Distance, in longest edges from the centroid, beyond which lamps are sampled by area. Compared with 10,
// errors grow by at most 2 % with 5, and by up to 30 % with 2.
constexpr double far_away = 5.0;

// The corners as seen from x, and the quantities that select the sampling method.
struct View {
  std::array<Vec3d, 3> corner;
  double height;  // of x over the lamp's plane

  View(const LampTriangle& lamp, const Vec3d& x)
      : corner{Vec3d(lamp.corner[0]) - x, Vec3d(lamp.corner[1]) - x, Vec3d(lamp.corner[2]) - x},
        height(-glm::dot(lamp.normal, corner[0])) {}
  bool is_far(const LampTriangle& lamp) const {
    const auto three_centroids = corner[0] + corner[1] + corner[2];
    const auto reach = 3.0 * far_away * lamp.longest_edge;
    return glm::dot(three_centroids, three_centroids) > reach * reach;
  }
};

double density_of_area(const LampTriangle& lamp, double height, double distance) {
  return distance * distance * distance / (height * lamp.area);
}

}  // namespace

LampSample sample_lamp(const LampTriangle& lamp, const Vec3d& x, double u1, double u2) {
  assert(u1 >= 0.0 && u1 <= 1.0 && u2 >= 0.0 && u2 <= 1.0);
  const View view(lamp, x);
  const auto& corner = view.corner;
  if (!(view.height > 0.0)) return {};
  if (view.is_far(lamp)) {
    const auto root = std::sqrt(u1);
    const auto point =
        corner[0] + ((1.0 - u2) * root) * (corner[1] - corner[0]) + (u2 * root) * (corner[2] - corner[0]);
    const auto distance = glm::length(point);
    return {point / distance, distance, density_of_area(lamp, view.height, distance)};
  }
  const SphericalTriangle seen(corner);
  if (!(seen.solid_angle() > 0.0)) return {};
  const auto direction = seen.direction(u1, u2);
  // Near the horizon of the lamp the quotient loses precision; no point is farther away than a corner.
  const auto farthest = std::max({glm::length(corner[0]), glm::length(corner[1]), glm::length(corner[2])});
  const auto down = -glm::dot(lamp.normal, direction);
  const auto distance = down * farthest > view.height ? view.height / down : farthest;
  return {direction, distance, seen.density()};
}

double lamp_density(const LampTriangle& lamp, const Vec3d& x, const Vec3d& direction) {
  assert(is_unit(direction));
  const View view(lamp, x);
  const auto down = -glm::dot(lamp.normal, direction);
  if (!(view.height > 0.0) || !(down > 0.0)) return 0.0;
  if (view.is_far(lamp)) return density_of_area(lamp, view.height, view.height / down);
  const SphericalTriangle seen(view.corner);
  return seen.solid_angle() > 0.0 ? seen.density() : 0.0;
}

}  // namespace luxel
