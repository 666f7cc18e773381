// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/import/load_scene.h"

namespace luxel {

// Gives the scene its sky and its sun: 9,217 patches above the horizon (one where the sky is uniform) and one
// of the ground, or those of a picture on both sides of it, and a directional light named "sun" with the disc
// of the sun. Bright spots of a picture, its sun above all, become such lights, named "sun", too: rays would
// seldom find them.
//
// up: (0, 1, 0) or (0, 0, 1); 0: the scene's own, else estimated. Throws InputError where a number is out of
// its range, and where a picture cannot be read or is black. Cost: 20 ms, and the reading of a picture.
void set_daylight(const Daylight& daylight, const Vec3& up, Scene& scene);

// North in the scene's axes, unit and level: clockwise seen from above by so many degrees from -Z where +Y is
// up, else from +Y. up: unit.
Vec3d north_of(const Vec3d& up, double degrees);

// Illuminance by the sun of a plane that faces it under a CIE sky, lx, as Daylight::sun_illuminance has it.
double cie_sun_illuminance(int cie_type, double elevation);

}  // namespace luxel
