// SPDX-License-Identifier: Apache-2.0
#include "luxel/surface/flat_fragment.h"

#include <algorithm>
#include <cmath>

#include "luxel/core/bounds.h"
#include "luxel/core/convex_hull.h"
#include "luxel/patch/side.h"
#include "luxel/surface/cross.h"
#include "luxel/surface/flat_cover.h"

namespace luxel {
namespace {

using Point = glm::dvec2;
using Triangle = FlatCover::Triangle;

// Counter-clockwise.
std::vector<Point> convex_hull(std::vector<Point> points) {
  const auto before = [](const Point& a, const Point& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); };
  std::sort(points.begin(), points.end(), before);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return hull_of_sorted(
      points, [](const Point& a, const Point& b, const Point& c) { return cross(b - a, c - b) > 0.0; });
}

Box<Point> box_along(const std::vector<Point>& points, const Point& axis) {
  Box<Point> box;
  for (const auto& p : points) box.add({glm::dot(p, axis), cross(axis, p)});
  return box;
}

// The direction, unit, along which the bounding box is smallest.
Point best_axis(const std::vector<Point>& hull) {
  constexpr std::size_t max_edges = 256;  // a rounder hull has no preferred edge
  constexpr double better = 1.0 - 1e-6;
  Point best(1.0, 0.0);
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

Point on_plane(const std::array<Vec3d, 2>& axes, const Vec3& v) {
  return {glm::dot(axes[0], Vec3d(v)), glm::dot(axes[1], Vec3d(v))};
}

Triangle on_plane(const PatchSet& patches, const std::array<Vec3d, 2>& axes, SideId side) {
  Triangle t;
  for (std::size_t k = 0; k < 3; ++k)
    t[k] = on_plane(axes, patches.vertices[patches.corners[side.patch()][k]]);
  if (side.is_back()) std::swap(t[1], t[2]);
  return t;
}

// Two axes at right angles to a unit direction, so that (first, second, direction) is right-handed.
std::array<Vec3d, 2> axes_across(const Vec3d& direction) {
  const auto a = glm::abs(direction);
  const Vec3d other = a.x <= a.y && a.x <= a.z ? Vec3d(1, 0, 0)
                      : a.y <= a.z             ? Vec3d(0, 1, 0)
                                               : Vec3d(0, 0, 1);
  const auto s = glm::normalize(glm::cross(other, direction));
  return {s, glm::cross(direction, s)};
}

// Returns the factor of lengths by which the projection gets the area of the sides.
double stretch_of(const PatchSet& patches, std::span<const SideId> sides, const Vec3d& direction) {
  double area = 0.0, projected = 0.0;
  for (const auto side : sides) {
    const auto own = static_cast<double>(patches.area[side.patch()]);
    area += own;
    projected += own * std::max(0.0, glm::dot(facing(patches, side), direction));
  }
  constexpr double most = 1.5, rounding = 1e-5;
  const auto stretch = projected > 0.0 ? std::sqrt(area / projected) : 1.0;
  return stretch < 1.0 + rounding ? 1.0 : std::min(most, stretch);
}

}  // namespace

Chart flat_chart(const PatchSet& patches, std::vector<SideId> sides, const Vec3d& direction) {
  const auto axes = axes_across(direction);
  std::vector<Point> points;
  for (const auto side : sides)
    for (const auto& p : on_plane(patches, axes, side)) points.push_back(p);
  const auto hull = convex_hull(std::move(points));
  auto along = best_axis(hull);
  auto box = box_along(hull, along);
  if (box.size().y > box.size().x) {
    along = {-along.y, along.x};
    box = box_along(hull, along);
  }
  Chart chart;
  chart.axes = {along.x * axes[0] + along.y * axes[1], along.x * axes[1] - along.y * axes[0]};
  // Any depth is valid: the projection is along it.
  chart.origin = box.low.x * chart.axes[0] + box.low.y * chart.axes[1];
  chart.size = {box.size().x, box.size().y};
  chart.sides = std::move(sides);
  std::sort(chart.sides.begin(), chart.sides.end());
  chart.stretch = stretch_of(patches, chart.sides, direction);
  return chart;
}

Placed without_overlaps(const PatchSet& patches, std::span<const SideId> sides, const Vec3d& direction) {
  const auto axes = axes_across(direction);
  Box<Point> box;
  for (const auto side : sides)
    for (const auto& p : on_plane(patches, axes, side)) box.add(p);
  Placed result;
  FlatCover cover(box.low, box.high, sides.size());
  for (const auto side : sides)
    (cover.add(on_plane(patches, axes, side)) ? result.kept : result.over).push_back(side);
  return result;
}

}  // namespace luxel
