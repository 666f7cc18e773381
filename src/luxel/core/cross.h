// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/core/vector.h"

namespace luxel {

// In a plane: twice the area of the triangle (0, a, b), above 0 where it is counter-clockwise.
template <typename T>
T cross(const glm::vec<2, T>& a, const glm::vec<2, T>& b) {
  return a.x * b.y - a.y * b.x;
}

}  // namespace luxel
