// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenes/shapes/mesh.h"

namespace luxel::scenes {

// All closed, in metres, standing at the origin.

Mesh school_desk();             // 1.3 x 0.55 for two, top at 0.72; one sits at +z and looks towards -z
Mesh school_chair(Paint seat);  // facing +z, seat at 0.43
Mesh blackboard(double width, double height);  // in the plane z = 0 about the origin, facing +z; with a ledge
Mesh globe_on_stand();
Mesh exercise_book(Paint cover);
Mesh wall_clock();             // 0.36 across, in the plane z = 0, facing +z
Mesh radiator(double length);  // along x, 0.6 high

}  // namespace luxel::scenes
