// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "luxel/core/json.h"
#include "luxel/core/vector.h"

namespace luxel {

// The quaternion (x, y, z, w) of the shortest turn from up to +Y: up x y for the axis and 1 + up.y
// for the angle, as half angles would have it. Empty where no turn is needed. Throws InputError
// where up has no length.
std::vector<double> turn_to_y_up(const Vec3& up);

// Turns a glTF node's content from `up` to +Y, and moves it to its scene's origin (m), which is turned too.
// Throws InputError where up has no length.
void turn_node_y_up(Json& node, const Vec3& up, const Vec3d& origin);

// Returns the point turned by the quaternion, if any.
Vec3d turned(const std::vector<double>& rotation, const Vec3d& p);

}  // namespace luxel
