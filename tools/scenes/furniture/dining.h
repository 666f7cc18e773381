// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenes/shapes/mesh.h"

namespace luxel::scenes {

// All closed, standing at the origin. Metres.

Mesh dining_table();     // round, 1.25, top at dining_table_height
Mesh chair(Paint seat);  // facing +z, seat at 0.46
Mesh place_setting();    // a plate with a smaller one on it, and a mug to the right

inline constexpr double dining_table_height = 0.75;

}  // namespace luxel::scenes
