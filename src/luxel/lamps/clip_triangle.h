// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "luxel/core/vector.h"

namespace luxel {

// The part of a triangle on the upper side of a plane, as the corners of a polygon in the same sense. height:
// of each corner over the plane, to any scale. Returns the number of corners, up to four; fewer than three
// where nothing is left.
inline int clip_triangle(const std::array<Vec3d, 3>& corner, const std::array<double, 3>& height,
                         std::array<Vec3d, 4>& above) {
  int count = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto next = (i + 1) % 3;
    if (height[i] >= 0.0) above[static_cast<std::size_t>(count++)] = corner[i];
    if ((height[i] > 0.0 && height[next] < 0.0) || (height[i] < 0.0 && height[next] > 0.0)) {
      const auto t = height[i] / (height[i] - height[next]);
      above[static_cast<std::size_t>(count++)] = corner[i] + t * (corner[next] - corner[i]);
    }
  }
  return count;
}

}  // namespace luxel
