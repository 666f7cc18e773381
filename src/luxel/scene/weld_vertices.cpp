// SPDX-License-Identifier: Apache-2.0
#include "luxel/scene/weld_vertices.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <unordered_map>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/core/none.h"
#include "luxel/scene/triangle_shape.h"
#include "luxel/scene/vertex_weld.h"

namespace luxel {
namespace {

using Cell = std::array<std::int64_t, 3>;

struct CellHash {
  std::size_t operator()(const Cell& c) const {
    auto h = static_cast<std::uint64_t>(c[0]) * 0x9e3779b97f4a7c15u;
    h = (h ^ (h >> 32) ^ static_cast<std::uint64_t>(c[1])) * 0xbf58476d1ce4e5b9u;
    h = (h ^ (h >> 32) ^ static_cast<std::uint64_t>(c[2])) * 0x94d049bb133111ebu;
    return h ^ (h >> 32);
  }
};

// The points that remain, in a grid of cells as wide as the distance.
class Stayed {
 public:
  Stayed(std::span<const Vec3> points, double distance)
      : points_(points), distance_(distance), width_(distance), next_(points.size(), none) {
    first_.reserve(points.size());
    for (const auto& p : points)  // wider than the spacing of floats, so that 64 bits count all cells
      width_ = std::max(
          width_, 0x1p-60 * std::max({std::abs(static_cast<double>(p.x)), std::abs(static_cast<double>(p.y)),
                                      std::abs(static_cast<double>(p.z))}));
  }

  // Returns the nearest point within reach, or none.
  std::uint32_t near(const Vec3& p) const {
    const auto home = cell(p);
    auto best = none;
    auto best2 = distance_ * distance_;
    for (std::int64_t x = -1; x <= 1; ++x)
      for (std::int64_t y = -1; y <= 1; ++y)
        for (std::int64_t z = -1; z <= 1; ++z) {
          const auto found = first_.find({home[0] + x, home[1] + y, home[2] + z});
          if (found == first_.end()) continue;
          for (auto i = found->second; i != none; i = next_[i]) {
            const auto d = Vec3d(points_[i]) - Vec3d(p);
            const auto d2 = glm::dot(d, d);
            if (d2 > best2 || (d2 == best2 && i > best)) continue;
            best2 = d2;
            best = i;
          }
        }
    return best;
  }

  void add(std::uint32_t i) {
    const auto [place, is_new] = first_.try_emplace(cell(points_[i]), i);
    if (is_new) return;
    next_[i] = place->second;
    place->second = i;
  }

 private:
  Cell cell(const Vec3& p) const {
    const auto number = [&](float x) {
      return static_cast<std::int64_t>(std::floor(static_cast<double>(x) / width_));
    };
    return {number(p.x), number(p.y), number(p.z)};
  }

  std::span<const Vec3> points_;
  double distance_, width_;
  std::unordered_map<Cell, std::uint32_t, CellHash> first_;  // first point of a cell; never iterated
  std::vector<std::uint32_t> next_;                          // in the same cell
};

bool triangle_has_area(const Scene& scene, std::size_t triangle) {
  const auto& t = scene.triangles[triangle];
  return has_area(scene.positions[t[0]], scene.positions[t[1]], scene.positions[t[2]]);
}

}  // namespace

std::vector<std::uint32_t> weld_points(std::span<const Vec3> points, double distance) {
  if (!(distance >= 0.0 && std::isfinite(distance)))
    throw InputError(fmt::format("expected a weld distance of 0 or more metres, found {}", distance));
  std::vector<std::uint32_t> goes_to(points.size());
  std::iota(goes_to.begin(), goes_to.end(), 0u);
  if (distance == 0.0) return goes_to;
  Stayed stayed(points, distance);
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const auto near = stayed.near(points[i]);
    if (near == none)
      stayed.add(i);
    else
      goes_to[i] = near;
  }
  return goes_to;
}

WeldReport weld_vertices(Scene& scene, double distance) {
  VertexWeld weld;
  std::vector<std::uint32_t> place(scene.positions.size(), none);
  std::vector<std::uint8_t> had_area(scene.triangles.size());
  for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
    had_area[t] = triangle_has_area(scene, t) ? 1 : 0;
    for (const auto v : scene.triangles[t])
      if (place[v] == none) place[v] = weld.index_of(scene.positions[v]);
  }
  const auto& places = weld.positions();
  const auto goes_to = weld_points(places, distance);

  WeldReport report;
  report.places = places.size();
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (goes_to[i] == i) continue;
    ++report.moved;
    report.farthest = std::max(report.farthest, glm::distance(Vec3d(places[i]), Vec3d(places[goes_to[i]])));
  }
  for (std::size_t v = 0; v < scene.positions.size(); ++v)
    if (place[v] != none) scene.positions[v] = places[goes_to[place[v]]];
  for (std::size_t t = 0; t < scene.triangles.size(); ++t)
    if (had_area[t] != 0 && !triangle_has_area(scene, t)) ++report.collapsed;
  return report;
}

std::string WeldReport::as_text(double distance) const {
  if (moved == 0)
    return fmt::format("welding within {:g} m: no two vertices are that near; nothing was changed", distance);
  auto text =
      fmt::format("welding within {:g} m: {} of {} vertices moved onto another one, by {:.2g} m at most",
                  distance, moved, places, farthest);
  if (collapsed > 0)
    text += fmt::format("; {} lost {} area by it",
                        collapsed == 1 ? "1 triangle" : fmt::format("{} triangles", collapsed),
                        collapsed == 1 ? "its" : "their");
  return text;
}

}  // namespace luxel
