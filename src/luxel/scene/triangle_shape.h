// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/core/vector.h"

namespace luxel {

// Whether a triangle has a plane that floats can tell: more height than half a unit in the last place of its
// largest coordinate. With less, what is left is rounding, and so is its normal.
bool has_area(const Vec3& a, const Vec3& b, const Vec3& c);

// The longest edge over the height that stands on it: 1.15 for an equilateral triangle, infinite without
// area.
double slenderness(const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace luxel
