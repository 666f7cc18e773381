// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "luxel/core/vector.h"

namespace luxel {

// A point on the border of a triangle.
struct BorderPoint {
  Vec3d place{0.0};
  // Bit k: it lies on the edge from the triangle's corner k to the next; a corner lies on two.
  unsigned edges = 0;
};

// Cuts a triangle so that all of these points, which go round its border in its winding and begin with the
// three corners among them, are corners. Returns indices of points; every piece has area if the triangle has,
// and the best shaped is cut off first. At least three points; cost: their number squared.
std::vector<std::array<std::uint32_t, 3>> cut_along_edges(const std::vector<BorderPoint>& points);

}  // namespace luxel
