// SPDX-License-Identifier: Apache-2.0
#include "luxel/lamps/outline_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

#include "luxel/patch/line_search.h"
#include "luxel/trace/point_sight.h"

namespace luxel {
namespace {

constexpr double edge_on = 1e-4;  // sine below which a triangle lies in the plane of its edge and the light
constexpr std::size_t grain = 4096;

// One edge of one triangle, seen from the light.
class EdgeView {
 public:
  EdgeView(const PatchSet& triangles, const VertexTriangles& neighbours, const BandPointLight& light)
      : triangles_(triangles),
        neighbours_(neighbours),
        light_(light.light),
        power_(std::accumulate(light.intensity.begin(), light.intensity.end(), 0.0)) {}

  std::optional<OutlineEdge> outline(std::uint32_t triangle, std::size_t k) const {
    const auto& c = triangles_.corners[triangle];
    const auto i = c[k], j = c[(k + 1) % 3];
    OutlineEdge edge{
        .a = Vec3d(triangles_.vertices[i]), .b = Vec3d(triangles_.vertices[j]), .corners = {i, j}};
    const auto middle = 0.5 * (edge.a + edge.b);
    const auto towards = sight_of(light_, middle, Vec3d(0.0)).direction;
    const auto across = glm::cross(edge.b - edge.a, towards);
    const auto length = glm::length(across);
    if (!(length > 0.0)) return std::nullopt;
    const auto side_of = [&](std::uint32_t apex) {
      return glm::dot(across / length, away_from_edge(triangles_.vertices, i, j, apex));
    };
    const auto own = side_of(c[(k + 2) % 3]);
    double low = own, high = own;
    if (neighbours_.any_at_edge(i, j, triangle, [&](std::uint32_t other, std::uint32_t apex) {
          const auto side = side_of(apex);
          low = std::min(low, side);
          high = std::max(high, side);
          return other < triangle || (low < -edge_on && high > edge_on);
        }))
      return std::nullopt;
    edge.outward = (high > edge_on ? -across : across) / length;
    edge.weight = length * power_ * sight_of(light_, middle, towards).irradiance;
    return edge.weight > 0.0 ? std::optional(edge) : std::nullopt;
  }

 private:
  const PatchSet& triangles_;
  const VertexTriangles& neighbours_;
  const PointLight& light_;
  double power_;  // sum of the intensities of bands
};

}  // namespace

std::vector<OutlineEdge> find_outline_edges(const PatchSet& triangles, const VertexTriangles& neighbours,
                                            const BandPointLight& light, const Context& context) {
  const EdgeView view(triangles, neighbours, light);
  std::vector<std::vector<OutlineEdge>> of_chunk((triangles.size() + grain - 1) / grain);
  context.for_chunks(triangles.size(), grain, [&](std::size_t begin, std::size_t end, int) {
    auto& edges = of_chunk[begin / grain];
    for (auto t = begin; t < end; ++t)
      for (std::size_t k = 0; k < 3; ++k)
        if (const auto edge = view.outline(static_cast<std::uint32_t>(t), k)) edges.push_back(*edge);
  });
  std::vector<OutlineEdge> result;
  for (const auto& edges : of_chunk) result.insert(result.end(), edges.begin(), edges.end());
  return result;
}

}  // namespace luxel
