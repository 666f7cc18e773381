// SPDX-License-Identifier: Apache-2.0
#include "luxel/patch/clean_triangles.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "luxel/math/triangle.h"

namespace luxel {
namespace {

constexpr double smallest_area2 = 1e-34;  // m²; a float still holds it, and a power over it

std::string where(const Scene& scene, std::uint32_t triangle) {
  const auto line = scene.triangle_line[triangle];
  return line > 0 ? fmt::format("the first at {}:{}", scene.source, line)
                  : fmt::format("the first is triangle {}", triangle);
}

bool is_lamp(const Scene& scene, const CleanTriangle& t) {
  return scene.materials[static_cast<std::size_t>(scene.triangle_material[t.triangle])].is_lamp();
}

std::vector<CleanTriangle> with_area(const Scene& scene, VertexWeld& weld, const LogSink& log) {
  std::vector<CleanTriangle> kept;
  kept.reserve(scene.triangles.size());
  // The weld is asked once a vertex of the file, not once a corner.
  constexpr auto unknown = 0xffffffffu;
  std::vector<std::uint32_t> welded(scene.positions.size(), unknown);
  const auto weld_corner = [&](std::uint32_t v) {
    if (welded[v] == unknown) welded[v] = weld.index_of(scene.positions[v]);
    return welded[v];
  };
  std::size_t dropped = 0;
  std::uint32_t first = 0;
  for (std::uint32_t t = 0; t < scene.triangles.size(); ++t) {
    if (!scene.materials[static_cast<std::size_t>(scene.triangle_material[t])].opaque) continue;
    const auto& v = scene.triangles[t];
    if (has_area(scene.positions[v[0]], scene.positions[v[1]], scene.positions[v[2]])) {
      kept.push_back({{weld_corner(v[0]), weld_corner(v[1]), weld_corner(v[2])}, t});
    } else if (dropped++ == 0) {
      first = t;
    }
  }
  if (dropped > 0)
    warn(log, fmt::format("{} of {} triangles have no area and are left out ({})", dropped,
                          scene.triangles.size(), where(scene, first)));
  return kept;
}

// Corners rotated so that the smallest comes first: equal for equal triangles of equal winding.
std::array<std::uint32_t, 3> rotated(std::array<std::uint32_t, 3> c) {
  std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
  return c;
}

std::array<std::uint32_t, 3> sorted(std::array<std::uint32_t, 3> c) {
  std::sort(c.begin(), c.end());
  return c;
}

// The triangles in an order where those on the same three vertices stand together, the one to keep first.
std::vector<std::uint32_t> by_place(const Scene& scene, const std::vector<CleanTriangle>& triangles,
                                    std::size_t vertices) {
  // Counted out by their smallest corner, which leaves short runs to sort.
  std::vector<std::uint32_t> begin(vertices + 1, 0);
  const auto smallest = [](const CleanTriangle& t) {
    return std::min({t.corners[0], t.corners[1], t.corners[2]});
  };
  for (const auto& t : triangles) ++begin[smallest(t) + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<std::uint32_t> order(triangles.size());
  auto next = begin;
  for (std::uint32_t i = 0; i < triangles.size(); ++i) order[next[smallest(triangles[i])]++] = i;

  const auto comes_before = [&](std::uint32_t i, std::uint32_t j) {
    const auto a = sorted(triangles[i].corners);
    const auto b = sorted(triangles[j].corners);
    if (a != b) return a < b;
    const bool lamp_i = is_lamp(scene, triangles[i]);
    const bool lamp_j = is_lamp(scene, triangles[j]);
    return lamp_i != lamp_j ? lamp_i : i < j;
  };
  for (std::size_t v = 0; v < vertices; ++v)
    std::sort(order.begin() + begin[v], order.begin() + begin[v + 1], comes_before);
  return order;
}

}  // namespace

bool has_area(const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto length2 = [](const Vec3d& edge) { return glm::dot(edge, edge); };
  const auto longest = std::sqrt(
      std::max({length2(Vec3d(b) - Vec3d(a)), length2(Vec3d(c) - Vec3d(b)), length2(Vec3d(a) - Vec3d(c))}));
  const auto largest = glm::max(glm::max(glm::abs(a), glm::abs(b)), glm::abs(c));
  const auto rounding = 0x1p-24 * std::max({largest.x, largest.y, largest.z});
  const auto area2 = glm::length(area_vector2(a, b, c));
  return area2 > rounding * longest && area2 > smallest_area2;
}

std::vector<CleanTriangle> clean_triangles(const Scene& scene, VertexWeld& weld, const LogSink& log) {
  auto triangles = with_area(scene, weld, log);

  // Piles of triangles on the same three vertices, the one to keep first in each.
  const auto order = by_place(scene, triangles, weld.positions().size());
  std::vector<bool> drop(triangles.size(), false);
  std::size_t dropped = 0;
  auto first = static_cast<std::uint32_t>(scene.triangles.size());
  for (std::size_t i = 0, pile = 0; i < order.size(); ++i) {
    if (sorted(triangles[order[i]].corners) != sorted(triangles[order[pile]].corners)) pile = i;
    if (i == pile) continue;
    auto& kept = triangles[order[pile]];
    const auto& other = triangles[order[i]];
    if (rotated(kept.corners) != rotated(other.corners)) kept.opposite_twin = true;
    drop[order[i]] = true;
    ++dropped;
    first = std::min(first, other.triangle);
  }
  if (dropped == 0) return triangles;
  warn(log, fmt::format(
                "{} triangles lie exactly on another one and are left out ({}); the one that stays is lit on "
                "both sides where they faced opposite ways",
                dropped, where(scene, first)));
  std::vector<CleanTriangle> kept;
  kept.reserve(triangles.size() - dropped);
  for (std::size_t i = 0; i < triangles.size(); ++i)
    if (!drop[i]) kept.push_back(triangles[i]);
  return kept;
}

}  // namespace luxel
