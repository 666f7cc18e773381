// SPDX-License-Identifier: Apache-2.0
#include "luxel/surface/cut_along_edges.h"

#include <algorithm>

namespace luxel {
namespace {

// Twice the area over the square of the longest side.
double shape(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const auto square = [](const Vec3d& v) { return glm::dot(v, v); };
  const auto longest = std::max({square(b - a), square(c - b), square(a - c)});
  return longest > 0.0 ? glm::length(glm::cross(b - a, c - a)) / longest : 0.0;
}

}  // namespace

// Ear clipping. The edges define which points are collinear, so that rounding has no influence.
std::vector<std::array<std::uint32_t, 3>> cut_along_edges(const std::vector<BorderPoint>& points) {
  std::vector<std::uint32_t> open;
  for (std::uint32_t i = 0; i < points.size(); ++i) open.push_back(i);
  const auto ear_at = [&](std::size_t i) {
    const auto n = open.size();
    return std::array{open[(i + n - 1) % n], open[i], open[(i + 1) % n]};
  };
  const auto has_area = [&](const std::array<std::uint32_t, 3>& t) {
    return (points[t[0]].edges & points[t[1]].edges & points[t[2]].edges) == 0;
  };
  const auto leaves_area = [&](std::size_t without) {
    auto shared = ~0u;
    for (std::size_t i = 0; i < open.size(); ++i)
      if (i != without) shared &= points[open[i]].edges;
    return open.size() == 3 || shared == 0;
  };
  std::vector<std::array<std::uint32_t, 3>> fragments;
  while (open.size() >= 3) {
    std::size_t best = open.size();
    double best_shape = -1.0;
    for (std::size_t i = 0; i < open.size(); ++i) {
      const auto ear = ear_at(i);
      if (!has_area(ear) || !leaves_area(i)) continue;
      const auto here = shape(points[ear[0]].place, points[ear[1]].place, points[ear[2]].place);
      if (!(here > best_shape)) continue;
      best = i;
      best_shape = here;
    }
    if (best == open.size()) break;  // a triangle without area
    fragments.push_back(ear_at(best));
    open.erase(open.begin() + static_cast<std::ptrdiff_t>(best));
  }
  return fragments;
}

}  // namespace luxel
