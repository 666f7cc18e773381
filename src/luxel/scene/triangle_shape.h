// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/core/vector.h"

namespace luxel {

// Returns whether the plane of a triangle is representable in floats: its height is more than half a unit in
// the last place of its largest coordinate. Below that its shape, and so its normal, is rounding.
bool has_area(const Vec3& a, const Vec3& b, const Vec3& c);

// Length of the longest edge.
double longest_edge(const Vec3& a, const Vec3& b, const Vec3& c);

// The longest edge over the height that stands on it: 1.15 for an equilateral triangle, infinite without
// area.
double slenderness(const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace luxel
