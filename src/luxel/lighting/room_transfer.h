// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace luxel {

struct RoomReflectance {
  double ceiling = 0.7, wall = 0.5, floor = 0.2;  // [0, 1)
};

// Indirect illuminance of the walls of an empty room times their area, per lumen that falls directly onto one
// of its surfaces, lx m²/lm: the factors F_T of CIE 190.
struct WallTransfer {
  double from_floor = 0.0, from_wall = 0.0, from_ceiling = 0.0;
};

// Radiosity of a box of three surfaces: floor, the four walls as one, ceiling, each of constant radiosity;
// form factors in closed form, and a 3 x 3 system. length, width: sides of the floor over the height, above
// 0.
WallTransfer wall_transfer(double length, double width, const RoomReflectance& reflectance);

}  // namespace luxel
