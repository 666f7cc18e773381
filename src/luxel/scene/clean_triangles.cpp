// SPDX-License-Identifier: Apache-2.0
#include "luxel/scene/clean_triangles.h"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "luxel/core/none.h"
#include "luxel/scene/triangle_shape.h"

namespace luxel {
namespace {

std::string where(const Scene& scene, std::uint32_t triangle) {
  const auto line = scene.triangle_line[triangle];
  return line > 0 ? fmt::format("the first at {}:{}", scene.source, line)
                  : fmt::format("the first is triangle {}", triangle);
}

bool is_lamp(const Scene& scene, const CleanTriangle& t) {
  return scene.materials[static_cast<std::size_t>(scene.triangle_material[t.triangle])].is_lamp();
}

// Sorts the scene's triangles by whether they have area.
CleanTriangles by_area(const Scene& scene, VertexWeld& weld) {
  CleanTriangles result;
  result.kept.reserve(scene.triangles.size());
  // The weld is looked up once per vertex of the file, not once per corner.
  std::vector<std::uint32_t> welded(scene.positions.size(), none);
  const auto weld_corner = [&](std::uint32_t v) {
    if (welded[v] == none) welded[v] = weld.index_of(scene.positions[v]);
    return welded[v];
  };
  for (std::uint32_t t = 0; t < scene.triangles.size(); ++t) {
    if (!scene.materials[static_cast<std::size_t>(scene.triangle_material[t])].opaque) continue;
    const auto& v = scene.triangles[t];
    if (has_area(scene.positions[v[0]], scene.positions[v[1]], scene.positions[v[2]]))
      result.kept.push_back({{weld_corner(v[0]), weld_corner(v[1]), weld_corner(v[2])}, t});
    else
      result.without_area.push_back(t);
  }
  return result;
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

// Orders the triangles so that those on the same three vertices are adjacent, the one to keep first.
std::vector<std::uint32_t> by_place(const Scene& scene, const std::vector<CleanTriangle>& triangles,
                                    std::size_t vertices) {
  // A counting sort by the smallest corner leaves short runs to sort.
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

CleanTriangles clean_triangles(const Scene& scene, VertexWeld& weld, const Context& context) {
  auto result = by_area(scene, weld);
  if (!result.without_area.empty())
    context.warn(fmt::format("{} of {} triangles have no area and are left out ({})",
                             result.without_area.size(), scene.triangles.size(),
                             where(scene, result.without_area.front())));

  // Groups of triangles on the same three vertices, the one to keep first in each.
  auto& triangles = result.kept;
  const auto order = by_place(scene, triangles, weld.positions().size());
  std::vector<std::uint32_t> lies_on(triangles.size(), none);
  for (std::size_t i = 0, pile = 0; i < order.size(); ++i) {
    if (sorted(triangles[order[i]].corners) != sorted(triangles[order[pile]].corners)) pile = i;
    if (i == pile) continue;
    lies_on[order[i]] = order[pile];
    auto& kept = triangles[order[pile]];
    if (rotated(kept.corners) != rotated(triangles[order[i]].corners)) kept.opposite_twin = true;
  }

  // Compact the array, and record the triangle that each removed one lies on.
  std::vector<std::uint32_t> place(triangles.size());
  std::uint32_t count = 0;
  for (std::size_t i = 0; i < triangles.size(); ++i)
    if (lies_on[i] == none) place[i] = count++;
  for (std::size_t i = 0; i < triangles.size(); ++i)
    if (lies_on[i] != none)
      result.twins.push_back({triangles[i].triangle, place[lies_on[i]],
                              rotated(triangles[i].corners) != rotated(triangles[lies_on[i]].corners)});
  if (result.twins.empty()) return result;
  for (std::size_t i = 0; i < triangles.size(); ++i)
    if (lies_on[i] == none) triangles[place[i]] = triangles[i];
  triangles.resize(count);
  context.warn(fmt::format(
      "{} triangles lie exactly on another one and are left out ({}); the one that stays is lit on "
      "both sides where they faced opposite ways",
      result.twins.size(), where(scene, result.twins.front().triangle)));
  return result;
}

}  // namespace luxel
