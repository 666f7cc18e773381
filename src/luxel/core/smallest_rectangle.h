// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "luxel/core/bounds.h"
#include "luxel/core/vector.h"

namespace luxel {

// A rectangle in a plane, which may be turned.
struct TurnedRectangle {
  glm::dvec2 along{1.0, 0.0};  // unit: its longer sides
  Box<glm::dvec2> box;         // in coordinates along that direction, and anticlockwise across it
};

// The smallest rectangle around points that are not all at one place; that with the given axes where it is as
// small. One of its sides lies on a side of the convex hull (Freeman and Shapira 1975). n log n, and at most
// 256 n.
TurnedRectangle smallest_rectangle(std::vector<glm::dvec2> points);

}  // namespace luxel
