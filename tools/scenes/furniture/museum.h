// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "scenes/shapes/mesh.h"

namespace luxel::scenes {

// In metres, standing at the origin; closed unless they say otherwise.

Mesh plinth(double width, double height);
Mesh knot_sculpture();     // 0.7 m: a trefoil knot of bronze
Mesh stacked_sculpture();  // 1.2 m: pebbles of marble
Mesh figure_sculpture();   // 1.1 m: a turned figure that twists
Mesh museum_bench();       // 1.8 x 0.5, along x

// A painting on the wall z = 0, facing +z, centred at the origin: the frame, and the canvas with even fields
// of colour (open).
Mesh painting_frame(double width, double height);
Mesh painting_canvas(double width, double height, std::uint64_t which);

// A luminaire that washes a wall, on a track that runs along x above it: housing with a cylinder that looks
// along (0, -1, 0) turned towards +z, and its lamp (open).
Mesh washer_housing(double tilt_degrees);
Mesh washer_lamp(double tilt_degrees);

}  // namespace luxel::scenes
