// SPDX-License-Identifier: Apache-2.0
#include "luxel/surface/flat_fragment.h"

#include <algorithm>
#include <cmath>

#include "luxel/core/bounds.h"
#include "luxel/core/smallest_rectangle.h"
#include "luxel/patch/side.h"
#include "luxel/surface/flat_cover.h"

namespace luxel {
namespace {

using Point = glm::dvec2;
using Triangle = FlatCover::Triangle;

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
  const auto [along, box] = smallest_rectangle(std::move(points));
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
