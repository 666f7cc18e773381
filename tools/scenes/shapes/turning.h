// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scenes/shapes/mesh.h"

namespace luxel::scenes {

// Turned on the lathe about the y axis. A profile is a row of (radius, height); where it rises, the surface
// faces away from the axis. A profile that begins and ends on the axis (radius 0) gives a closed body, any
// other an open sheet. segments: 24 or more look round.
using Profile = std::vector<glm::dvec2>;
Mesh lathe(const Profile& profile, int segments);

// The row of points made smooth: steps points on each span of a Catmull-Rom curve through the profile.
Profile smooth(const Profile& profile, int steps);

Mesh sphere(double radius, int segments = 20);                   // centred at the origin
Mesh cylinder(double radius, double height, int segments = 24);  // stands on y = 0

}  // namespace luxel::scenes
