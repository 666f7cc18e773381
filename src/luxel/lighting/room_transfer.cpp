// SPDX-License-Identifier: Apache-2.0
#include "luxel/lighting/room_transfer.h"

#include <array>

#include "luxel/core/vector.h"
#include "luxel/form_factors/polygon_form_factor.h"

namespace luxel {
namespace {

enum Surface { floor_surface, wall_surface, ceiling_surface };

// Form factor from the floor to the ceiling, which are 1 apart.
double floor_to_ceiling(double length, double width) {
  const std::array<Vec3d, 4> floor = {
      {{0.0, 0.0, 0.0}, {length, 0.0, 0.0}, {length, width, 0.0}, {0.0, width, 0.0}}};
  const std::array<Vec3d, 4> ceiling = {
      {{0.0, 0.0, 1.0}, {0.0, width, 1.0}, {length, width, 1.0}, {length, 0.0, 1.0}}};
  return polygon_form_factor(floor, ceiling);
}

}  // namespace

WallTransfer wall_transfer(double length, double width, const RoomReflectance& reflectance) {
  const auto opposite = floor_to_ceiling(length, width);
  const auto area = length * width, wall_area = 2.0 * (length + width);
  const auto to_wall = 1.0 - opposite, from_wall = to_wall * area / wall_area;
  // Row by row: factors from each surface, which by reciprocity average what it receives.
  const std::array<Vec3d, 3> factors = {Vec3d(0.0, to_wall, opposite),
                                        Vec3d(from_wall, 1.0 - 2.0 * from_wall, from_wall),
                                        Vec3d(opposite, to_wall, 0.0)};
  const Vec3d rho(reflectance.floor, reflectance.wall, reflectance.ceiling), areas(area, wall_area, area);
  glm::dmat3 system(1.0);  // [column][row]: 1 - rho F
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      system[column][row] -= rho[row] * factors[static_cast<std::size_t>(row)][column];
  const auto inverse = glm::inverse(system);
  const auto from = [&](Surface surface) {
    Vec3d first(0.0);  // radiosity after one reflection of one lumen
    first[surface] = rho[surface] / areas[surface];
    return wall_area * glm::dot(factors[wall_surface], inverse * first);
  };
  return {from(floor_surface), from(wall_surface), from(ceiling_surface)};
}

}  // namespace luxel
