// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "luxel/core/vector.h"

namespace luxel {

// The weights of a triangle's corners at the foot of the perpendicular from a point; they sum to one, and are
// in [0, 1] inside. A third each where the triangle has no area.
inline Vec3d barycentric(const std::array<Vec3, 3>& corners, const Vec3& point) {
  const auto b = Vec3d(corners[1]) - Vec3d(corners[0]);
  const auto c = Vec3d(corners[2]) - Vec3d(corners[0]);
  const auto d = Vec3d(point) - Vec3d(corners[0]);
  const auto bb = glm::dot(b, b), bc = glm::dot(b, c), cc = glm::dot(c, c);
  const auto db = glm::dot(d, b), dc = glm::dot(d, c);
  const auto determinant = bb * cc - bc * bc;
  if (!(determinant > 0.0)) return Vec3d(1.0 / 3.0);
  const auto s = (cc * db - bc * dc) / determinant;
  const auto t = (bb * dc - bc * db) / determinant;
  return {1.0 - s - t, s, t};
}

}  // namespace luxel
