// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/core/vector.h"

namespace luxel::test {

// Directions of a scene whose +Z is up and whose +Y is north.
inline const Vec3 up(0, 0, 1), down(0, 0, -1), north(0, 1, 0), south(0, -1, 0), east(1, 0, 0), west(-1, 0, 0);

}  // namespace luxel::test
