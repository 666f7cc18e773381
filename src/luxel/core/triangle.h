// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/core/vector.h"

namespace luxel {

// (b - a) x (c - a), in double: its length is twice the area, its direction the front of a counter-clockwise
// triangle. Double, so that slivers and triangles far from the origin keep their sign.
inline Vec3d area_vector2(const Vec3& a, const Vec3& b, const Vec3& c) {
  return glm::cross(Vec3d(b) - Vec3d(a), Vec3d(c) - Vec3d(a));
}

// Area in m².
inline double triangle_area(const Vec3& a, const Vec3& b, const Vec3& c) {
  return 0.5 * glm::length(area_vector2(a, b, c));
}

// Unit normal of the front, or zero where the triangle has no area.
inline Vec3 triangle_normal(const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto n = area_vector2(a, b, c);
  const auto length = glm::length(n);
  return length > 0.0 ? Vec3(n / length) : Vec3(0.0f);
}

}  // namespace luxel
