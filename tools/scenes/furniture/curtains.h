// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenes/shapes/mesh.h"

namespace luxel::scenes {

// A curtain hanging from y = height to just above the floor, from x = 0 to x = width, waving about z = 0.
// Open, seen from both sides. folds: how many.
Mesh curtain(double width, double height, int folds);

// A rod along x, centred at the origin, with a ball at each end. Closed.
Mesh curtain_rod(double length);

}  // namespace luxel::scenes
