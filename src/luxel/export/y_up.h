// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "luxel/core/json.h"
#include "luxel/core/vector.h"

namespace luxel {

// The quaternion (x, y, z, w) of the shortest turn from up to +Y: up x y for the axis and 1 + up.y for the
// angle, as half angles would have it. Empty where there is nothing to turn. Throws InputError where up has
// no length.
std::vector<double> turn_to_y_up(const Vec3& up);

// Turns a glTF node's content from `up` to +Y, and moves it to its scene's origin (m), turned likewise.
// Throws InputError where up has no length.
void turn_node_y_up(Json& node, const Vec3& up, const Vec3d& origin);

// A point turned by a quaternion, or as it is by none.
Vec3d turned(const std::vector<double>& rotation, const Vec3d& p);

}  // namespace luxel
