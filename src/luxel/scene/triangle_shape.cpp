// SPDX-License-Identifier: Apache-2.0
#include "luxel/scene/triangle_shape.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "luxel/core/triangle.h"

namespace luxel {
namespace {

constexpr double smallest_area2 = 1e-34;  // m²; this value, and a power divided by it, still fit a float

}  // namespace

double longest_edge(const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto length2 = [](const Vec3d& edge) { return glm::dot(edge, edge); };
  return std::sqrt(
      std::max({length2(Vec3d(b) - Vec3d(a)), length2(Vec3d(c) - Vec3d(b)), length2(Vec3d(a) - Vec3d(c))}));
}

bool has_area(const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto largest = glm::max(glm::max(glm::abs(a), glm::abs(b)), glm::abs(c));
  const auto rounding = 0x1p-24 * std::max({largest.x, largest.y, largest.z});
  const auto area2 = glm::length(area_vector2(a, b, c));
  return area2 > rounding * longest_edge(a, b, c) && area2 > smallest_area2;
}

double slenderness(const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto longest = longest_edge(a, b, c);
  const auto area2 = glm::length(area_vector2(a, b, c));
  return area2 > 0.0 ? longest * longest / area2 : std::numeric_limits<double>::infinity();
}

}  // namespace luxel
