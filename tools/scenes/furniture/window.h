// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenes/shapes/mesh.h"

namespace luxel::scenes {

// An opening in a wall, seen from the room: the window's hole lies in the plane z = 0 of its own frame, the
// room is towards +z, the night outside towards -z.
struct Opening {
  double width, height, depth;  // m; depth: how thick the wall is
};

Mesh reveal(const Opening& opening);        // open: the four sides of the hole, facing into it
Mesh window_frame(const Opening& opening);  // closed: casing, sash bars and sill

}  // namespace luxel::scenes
