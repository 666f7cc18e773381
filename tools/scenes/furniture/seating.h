// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenes/shapes/mesh.h"

namespace luxel::scenes {

// All closed, standing at the origin, facing +z. Metres.

struct Upholstery {
  double width = 2.1;
  int seats = 3;
  Paint cloth = Paint::teal_cloth;
};
Mesh sofa(const Upholstery& upholstery);  // depth 0.90, seat at 0.44; an armchair is a sofa with one seat

Mesh throw_pillow(Paint cloth, double side, double lean_degrees);  // its lower edge at y = 0, leaning back
Mesh pouf(Paint cloth);                                            // a round floor cushion

}  // namespace luxel::scenes
