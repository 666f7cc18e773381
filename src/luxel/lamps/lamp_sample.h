// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/core/vector.h"
#include "luxel/lamps/lamps.h"

namespace luxel {

// A point of a lamp as seen from x.
struct LampSample {
  Vec3d direction{0.0};   // unit, from x
  double distance = 0.0;  // m
  double density = 0.0;   // per steradian; 0 where x is not before the lamp: no sample
};

// Uniform in solid angle; where the lamp is far away for its size uniform in area, which is nearly the same
// thing there and five times as fast. u1, u2: uniform in [0, 1).
LampSample sample_lamp(const LampTriangle& lamp, const Vec3d& x, double u1, double u2);
// The density with which sample_lamp(lamp, x, ...) gives a direction that meets the lamp.
double lamp_density(const LampTriangle& lamp, const Vec3d& x, const Vec3d& direction);

}  // namespace luxel
