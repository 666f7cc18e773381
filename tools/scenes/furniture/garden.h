// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "scenes/shapes/mesh.h"

namespace luxel::scenes {

// In metres, standing at the origin; closed unless they say otherwise.

// A round-headed tree: trunk and boughs, and leaves (open) of which each is a small bent sheet.
Mesh tree_wood(double height, std::uint64_t which);
Mesh tree_leaves(double height, std::uint64_t which, int count);

Mesh hedge(double length, double width, double height, std::uint64_t which);  // along x
Mesh garden_bench();                                // 1.6 m long, one sits facing +z
Mesh fountain();                                    // 2.6 m across
Mesh street_lamp();                                 // 4.2 m high
Mesh planter(double width);                         // a square tub with earth in it
Mesh box_ball(double radius, std::uint64_t which);  // a clipped shrub

}  // namespace luxel::scenes
