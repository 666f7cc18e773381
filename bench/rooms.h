// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/scene/scene.h"

namespace luxel::bench {

// A closed room, 6 x 5 x 3 m, with `boxes` boxes of random place and size standing in it and a square lamp
// of one square metre under the ceiling, cut into `lamp_triangles` (2, 8, 32, 128, ...). Always the same
// room.
Scene furnished_room(int boxes, int lamp_triangles = 2);

}  // namespace luxel::bench
