// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "luxel/core/vector.h"

namespace luxel {

// A plane; heights over it are in metres where the normal is of unit length.
struct Plane {
  Vec3d point;
  Vec3d normal;

  double height(const Vec3d& p) const { return glm::dot(normal, p - point); }
};

// Replaces `above` by the part of a convex polygon on the upper side of a plane, in the same sense
// (Sutherland and Hodgman 1974). Fewer than three corners where nothing is left.
inline void clip_polygon(std::span<const Vec3d> polygon, const Plane& plane, std::vector<Vec3d>& above) {
  above.clear();
  if (polygon.empty()) return;
  auto p = polygon.back();
  auto hp = plane.height(p);
  for (const auto& q : polygon) {
    const auto hq = plane.height(q);
    if ((hp > 0.0 && hq < 0.0) || (hp < 0.0 && hq > 0.0)) above.push_back(p + hp / (hp - hq) * (q - p));
    if (hq >= 0.0) above.push_back(q);
    p = q;
    hp = hq;
  }
}

// Like clip_polygon(), but also gives the part on the lower side. heights: of the corners above the plane.
inline void split_polygon(std::span<const Vec3d> polygon, std::span<const double> heights,
                          std::vector<Vec3d>& above, std::vector<Vec3d>& below) {
  above.clear();
  below.clear();
  auto p = polygon.back();
  auto hp = heights.back();
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const auto& q = polygon[k];
    const auto hq = heights[k];
    if ((hp > 0.0 && hq < 0.0) || (hp < 0.0 && hq > 0.0)) {
      above.push_back(p + hp / (hp - hq) * (q - p));
      below.push_back(above.back());
    }
    if (hq >= 0.0) above.push_back(q);
    if (hq <= 0.0) below.push_back(q);
    p = q;
    hp = hq;
  }
}

}  // namespace luxel
