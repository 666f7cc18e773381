// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>

#include "luxel/core/cross.h"
#include "luxel/core/vector.h"

namespace luxel {

// Returns whether a bilinear lookup within the triangle reads the texel with its middle at p: whether the
// open square of two by two texels around p, the support of its weight, overlaps the triangle. All in texels.
// Weights below `rounding` do not count.
inline bool is_read_from(const std::array<glm::dvec2, 3>& t, const glm::dvec2& p, double rounding) {
  const auto reach = 1.0 - rounding;
  const auto low = glm::min(glm::min(t[0], t[1]), t[2]) - p;
  const auto high = glm::max(glm::max(t[0], t[1]), t[2]) - p;
  if (low.x >= reach || low.y >= reach || high.x <= -reach || high.y <= -reach) return false;
  // Looks for an edge of the triangle that separates the square from the third corner.
  for (std::size_t k = 0; k < 3; ++k) {
    const auto a = t[k] - p, edge = t[(k + 1) % 3] - t[k];
    const auto middle = cross(edge, -a);
    const auto corner = cross(edge, t[(k + 2) % 3] - t[k]);
    const auto half = reach * (std::abs(edge.x) + std::abs(edge.y));
    if (corner != 0.0 && (corner > 0.0 ? middle + half <= 0.0 : middle - half >= 0.0)) return false;
  }
  return true;
}

// Rounding for the layout of surfaces, and a larger one for filling texels: corners on a page are floats, so
// that a texel is filled only where it was laid out.
inline constexpr double layout_rounding = 1e-4, filling_rounding = 1e-3;

}  // namespace luxel
