// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenes/shapes/mesh.h"

namespace luxel::scenes {

// A rubber tree in a pot, standing at the origin, about 1.5 m high.
Mesh plant_pot();     // closed, with the soil in it
Mesh plant_stems();   // closed
Mesh plant_leaves();  // open, seen from both sides

// A bunch of twigs with leaves for a vase whose mouth is at the origin.
Mesh twig_stems(std::uint64_t which);   // closed
Mesh twig_leaves(std::uint64_t which);  // open

}  // namespace luxel::scenes
