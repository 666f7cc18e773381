// SPDX-License-Identifier: Apache-2.0
#include "luxel/surface/hanging_vertices.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "luxel/core/point_cells.h"

namespace luxel {
namespace {

struct PatchEdge {
  std::uint32_t patch, edge;
};

struct EdgeName {
  std::uint32_t low, high, code;  // code: 3 * patch + edge

  auto order() const { return std::tuple(low, high, code); }
  bool same(const EdgeName& o) const { return low == o.low && high == o.high; }
};

std::vector<PatchEdge> open_edges(const PatchSet& patches) {
  // A counting sort by their lower ends, then a sort of each short run.
  std::vector<std::size_t> begin(patches.vertices.size() + 1, 0);
  const auto ends = [&](std::size_t patch, std::size_t k) {
    const auto& c = patches.corners[patch];
    return std::pair(std::min(c[k], c[(k + 1) % 3]), std::max(c[k], c[(k + 1) % 3]));
  };
  for (std::size_t p = 0; p < patches.size(); ++p)
    for (std::size_t k = 0; k < 3; ++k) ++begin[ends(p, k).first + 1];
  for (std::size_t v = 1; v < begin.size(); ++v) begin[v] += begin[v - 1];
  std::vector<EdgeName> edges(3 * patches.size());
  auto next = begin;
  for (std::uint32_t p = 0; p < patches.size(); ++p)
    for (std::uint32_t k = 0; k < 3; ++k) {
      const auto [low, high] = ends(p, k);
      edges[next[low]++] = {low, high, 3 * p + k};
    }
  std::vector<PatchEdge> open;
  for (std::size_t v = 0; v + 1 < begin.size(); ++v) {
    const auto first = edges.begin() + static_cast<std::ptrdiff_t>(begin[v]);
    const auto last = edges.begin() + static_cast<std::ptrdiff_t>(begin[v + 1]);
    std::sort(first, last, [](const auto& a, const auto& b) { return a.order() < b.order(); });
    for (auto e = first; e != last; ++e) {
      const bool alone = (e == first || !e->same(*(e - 1))) && (e + 1 == last || !e->same(*(e + 1)));
      if (alone) open.push_back({e->code / 3, e->code % 3});
    }
  }
  return open;
}

std::array<std::uint32_t, 2> ends_of(const PatchSet& patches, const PatchEdge& e) {
  const auto& c = patches.corners[e.patch];
  return {c[e.edge], c[(e.edge + 1) % 3]};
}

}  // namespace

double line_tolerance(const Vec3& vertex, double length) {
  constexpr double hair = 1e-4;
  constexpr double rounding = 2.4e-7;  // two units in the last place of a float
  const auto far = std::max({std::abs(vertex.x), std::abs(vertex.y), std::abs(vertex.z)});
  return hair * length + rounding * static_cast<double>(far);
}

namespace {

std::vector<HangingVertex> hanging_on(const PatchSet& patches, const std::vector<PatchEdge>& edges) {
  std::vector<std::uint32_t> vertices;
  double length = 0.0;
  for (const auto& e : edges) {
    const auto [a, b] = ends_of(patches, e);
    vertices.insert(vertices.end(), {a, b});
    length += glm::distance(Vec3d(patches.vertices[a]), Vec3d(patches.vertices[b]));
  }
  if (!(length > 0.0)) return {};
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  const auto step = length / static_cast<double>(edges.size());
  std::vector<PointCells::Point> points;
  points.reserve(vertices.size());
  for (const auto v : vertices) points.push_back({Vec3d(patches.vertices[v]), v});
  const PointCells cells(points, step);

  std::vector<HangingVertex> hanging;
  for (const auto& e : edges) {
    const auto ends = ends_of(patches, e);
    const auto a = Vec3d(patches.vertices[ends[0]]), b = Vec3d(patches.vertices[ends[1]]);
    const auto along = b - a;
    const auto edge = glm::length(along);
    // A very long edge counts as at most ten thousand steps, so that boxes stay small.
    const auto counted = std::min(edge, 1e4 * step);
    const auto tolerance = std::max(line_tolerance(patches.vertices[ends[0]], counted),
                                    line_tolerance(patches.vertices[ends[1]], counted));
    // In steps, so that the box around a slanting edge does not hold half the scene.
    const auto pieces = static_cast<int>(std::ceil(edge / step));
    for (int i = 0; i < pieces; ++i) {
      const auto p = a + along * (static_cast<double>(i) / pieces);
      const auto q = a + along * (static_cast<double>(i + 1) / pieces);
      cells.for_each_in(glm::min(p, q) - tolerance, glm::max(p, q) + tolerance, [&](std::uint32_t v) {
        if (v == ends[0] || v == ends[1]) return;
        const auto d = Vec3d(patches.vertices[v]) - a;
        const auto fraction = glm::dot(d, along) / (edge * edge);
        const auto off = glm::length(d - fraction * along);
        const auto margin = tolerance / edge;
        if (off > tolerance || fraction <= margin || fraction >= 1.0 - margin) return;
        hanging.push_back({v, e.patch, e.edge, static_cast<float>(fraction)});
      });
    }
  }
  const auto order = [](const HangingVertex& h) { return std::tuple(h.vertex, h.patch, h.edge); };
  std::sort(hanging.begin(), hanging.end(),
            [&](const auto& a, const auto& b) { return order(a) < order(b); });
  hanging.erase(std::unique(hanging.begin(), hanging.end(),
                            [&](const auto& a, const auto& b) { return order(a) == order(b); }),
                hanging.end());
  return hanging;
}

}  // namespace

std::vector<HangingVertex> find_hanging_vertices(const PatchSet& patches) {
  return hanging_on(patches, open_edges(patches));
}

std::vector<HangingVertex> find_all_hanging_vertices(const PatchSet& patches) {
  std::vector<PatchEdge> edges;
  edges.reserve(3 * patches.size());
  for (std::uint32_t p = 0; p < patches.size(); ++p)
    for (std::uint32_t k = 0; k < 3; ++k) edges.push_back({p, k});
  return hanging_on(patches, edges);
}

}  // namespace luxel
