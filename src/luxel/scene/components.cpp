// SPDX-License-Identifier: Apache-2.0
#include "luxel/scene/components.h"

#include <array>

#include "luxel/core/none.h"
#include "luxel/core/triangle.h"

namespace luxel {
namespace {

// The edge at each corner of each triangle.
std::vector<std::array<std::uint32_t, 3>> edges_of_triangles(std::size_t triangles, const Edges& edges) {
  std::vector<std::array<std::uint32_t, 3>> result(triangles);
  for (std::uint32_t e = 0; e < edges.size(); ++e)
    for (const auto& use : edges.uses_of(e)) result[use.triangle][use.corner] = e;
  return result;
}

}  // namespace

Components find_components(std::span<const Vec3> places, std::span<const CleanTriangle> triangles,
                           const Edges& edges) {
  const auto edge_of = edges_of_triangles(triangles.size(), edges);
  Components result;
  result.of.assign(triangles.size(), none);
  result.is_turned.assign(triangles.size(), 0);
  result.order.reserve(triangles.size());
  for (std::uint32_t start = 0; start < triangles.size(); ++start) {
    if (result.of[start] != none) continue;
    const auto number = static_cast<std::uint32_t>(result.components.size());
    const Vec3d origin(places[triangles[start].corners[0]]);
    Piece component;
    auto head = result.order.size();
    result.begin.push_back(static_cast<std::uint32_t>(head));
    result.of[start] = number;
    result.order.push_back(start);
    for (; head < result.order.size(); ++head) {
      const auto t = result.order[head];
      const auto& c = triangles[t].corners;
      const bool turned = result.is_turned[t] != 0;
      const auto normal = area_vector2(places[c[0]], places[c[1]], places[c[2]]);
      const auto area = 0.5 * glm::length(normal);
      ++component.triangles;
      component.area += area;
      if (turned) component.area_turned += area;
      component.volume += (turned ? -1.0 : 1.0) * glm::dot(Vec3d(places[c[0]]) - origin, normal) / 6.0;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto e = edge_of[t][k];
        if (!edges.is_inner(e)) {
          component.is_closed = false;
          continue;
        }
        const auto uses = edges.uses_of(e);
        const auto other = uses[0].triangle == t ? uses[1].triangle : uses[0].triangle;
        const bool other_turned = turned != edges.winds_inconsistently(e);
        if (result.of[other] == none) {
          result.of[other] = number;
          result.is_turned[other] = other_turned ? 1 : 0;
          result.order.push_back(other);
        } else if ((result.is_turned[other] != 0) != other_turned) {
          component.is_orientable = false;
        }
      }
    }
    result.components.push_back(component);
  }
  result.begin.push_back(static_cast<std::uint32_t>(result.order.size()));
  return result;
}

}  // namespace luxel
