// SPDX-License-Identifier: Apache-2.0
#include "luxel/core/smallest_rectangle.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "luxel/core/convex_hull.h"
#include "luxel/core/cross.h"

namespace luxel {
namespace {

// Counter-clockwise.
std::vector<glm::dvec2> convex_hull(std::vector<glm::dvec2> points) {
  const auto before = [](const glm::dvec2& a, const glm::dvec2& b) {
    return a.x < b.x || (a.x == b.x && a.y < b.y);
  };
  std::sort(points.begin(), points.end(), before);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return hull_of_sorted(points, [](const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return cross(b - a, c - b) > 0.0;
  });
}

Box<glm::dvec2> box_along(const std::vector<glm::dvec2>& points, const glm::dvec2& axis) {
  Box<glm::dvec2> box;
  for (const auto& p : points) box.add({glm::dot(p, axis), cross(axis, p)});
  return box;
}

// The direction, unit, along which the bounding box is smallest.
glm::dvec2 best_axis(const std::vector<glm::dvec2>& hull) {
  constexpr std::size_t max_edges = 256;  // a rounder hull has no preferred edge
  constexpr double better = 1.0 - 1e-6;
  glm::dvec2 best(1.0, 0.0);
  const auto first = box_along(hull, best).size();
  auto least = first.x * first.y;
  const auto step = hull.size() / max_edges + 1;
  for (std::size_t i = 0; i < hull.size(); i += step) {
    const auto edge = hull[(i + 1) % hull.size()] - hull[i];
    const auto length = glm::length(edge);
    if (!(length > 0.0)) continue;
    const auto size = box_along(hull, edge / length).size();
    if (!(size.x * size.y < better * least)) continue;
    least = size.x * size.y;
    best = edge / length;
  }
  return best;
}

}  // namespace

TurnedRectangle smallest_rectangle(std::vector<glm::dvec2> points) {
  const auto hull = convex_hull(std::move(points));
  TurnedRectangle rectangle{.along = best_axis(hull), .box = {}};
  rectangle.box = box_along(hull, rectangle.along);
  if (rectangle.box.size().y > rectangle.box.size().x) {
    rectangle.along = {-rectangle.along.y, rectangle.along.x};
    rectangle.box = box_along(hull, rectangle.along);
  }
  return rectangle;
}

}  // namespace luxel
