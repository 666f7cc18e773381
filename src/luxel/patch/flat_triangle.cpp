// SPDX-License-Identifier: Apache-2.0
#include "luxel/patch/flat_triangle.h"

#include <algorithm>
#include <cmath>

#include "luxel/core/triangle.h"

namespace luxel {

double coordinate_rounding(const std::array<Vec3, 3>& corners) {
  const auto largest = glm::max(glm::max(glm::abs(corners[0]), glm::abs(corners[1])), glm::abs(corners[2]));
  return 0x1p-24 * static_cast<double>(std::max({largest.x, largest.y, largest.z}));
}

FlatTriangle::FlatTriangle(const std::array<Vec3, 3>& corners, const Vec3d& normal_direction)
    : corner{Vec3d(corners[0]), Vec3d(corners[1]), Vec3d(corners[2])},
      normal(glm::normalize(normal_direction)) {
  for (std::size_t k = 0; k < 3; ++k)
    inward[k] = glm::normalize(glm::cross(normal, corner[(k + 1) % 3] - corner[k]));
}

FlatTriangle::FlatTriangle(const std::array<Vec3, 3>& corners)
    : FlatTriangle(corners, area_vector2(corners[0], corners[1], corners[2])) {}

double FlatTriangle::smallest_height() const {
  return std::min({inside(0, corner[2]), inside(1, corner[0]), inside(2, corner[1])});
}

double FlatTriangle::along(std::size_t k, const Vec3d& p) const {
  const auto edge = corner[(k + 1) % 3] - corner[k];
  return glm::dot(p - corner[k], edge) / glm::dot(edge, edge);
}

std::optional<Interval> interval_over(const FlatTriangle& triangle, const Vec3d& p, const Vec3d& q,
                                      double slack) {
  Interval interval;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto a = triangle.inside(k, p) + slack;
    const auto b = triangle.inside(k, q) + slack;
    if (a < 0.0 && b < 0.0) return std::nullopt;
    if (a < 0.0) interval.begin = std::max(interval.begin, a / (a - b));
    if (b < 0.0) interval.end = std::min(interval.end, a / (a - b));
  }
  if (!(interval.begin <= interval.end)) return std::nullopt;
  return interval;
}

std::optional<EdgeInterval> interval_on_edge(const FlatTriangle& triangle, const Vec3d& p, const Vec3d& q,
                                             double slack) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (std::fabs(triangle.inside(k, p)) > slack || std::fabs(triangle.inside(k, q)) > slack) continue;
    const auto begin = std::clamp(triangle.along(k, p), 0.0, 1.0);
    const auto end = std::clamp(triangle.along(k, q), 0.0, 1.0);
    const auto edge = glm::distance(triangle.corner[k], triangle.corner[(k + 1) % 3]);
    return EdgeInterval{k, {begin, end}, std::fabs(end - begin) * edge};
  }
  return std::nullopt;
}

std::optional<Interval> interval_on(const FlatTriangle& triangle, const Vec3d& p, const Vec3d& q,
                                    double slack) {
  const auto at = [&](double fraction) { return p + fraction * (q - p); };
  if (const auto over = interval_over(triangle, p, q, 0.0);
      over && glm::distance(at(over->begin), at(over->end)) > slack)
    return over;
  const auto beside = interval_over(triangle, p, q, slack);
  if (!beside) return std::nullopt;
  constexpr double rounded = 1.0 + 1e-6;  // the ends may be out by exactly slack
  constexpr double shortest = 32.0;       // in slacks: any line that leaves the corner is this long within it
  const auto edge = interval_on_edge(triangle, at(beside->begin), at(beside->end), rounded * slack);
  return edge && edge->length > shortest * slack ? beside : std::nullopt;
}

}  // namespace luxel
