// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "luxel/core/vector.h"
#include "luxel/lamps/lamps.h"

namespace luxel {

// Irradiance, W/m², by the lamp's front on a surface at x with the unit normal n, for a radiance of 1 and
// without occlusion: pi times the form factor from the point to the triangle, in [0, pi]. The part below
// the horizon of x gives nothing; behind the lamp and in its plane it is 0. Lambert 1760, in the vector
// form of Arvo 1995. In double, relative error about 1e-15 times (distance / size of the lamp). Costs about
// 70 ns.
double unit_irradiance(const LampTriangle& lamp, const Vec3d& x, const Vec3d& n);

// Returns that of a flat convex polygon that lies wholly above the horizon of x, counter-clockwise seen from
// x; if clockwise, it is negative.
double unit_irradiance(std::span<const Vec3d> polygon, const Vec3d& x, const Vec3d& n);

}  // namespace luxel
