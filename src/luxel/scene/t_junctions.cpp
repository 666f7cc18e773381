// SPDX-License-Identifier: Apache-2.0
#include "luxel/scene/t_junctions.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "luxel/scene/point_tree.h"

namespace luxel {
namespace {

// The open edges at each vertex: edges[begin[v]] up to begin[v + 1].
struct OpenFans {
  std::vector<std::uint32_t> begin, edges;

  OpenFans(std::size_t vertices, const Edges& all) : begin(vertices + 1, 0) {
    for (std::size_t e = 0; e < all.size(); ++e)
      if (all.is_open(e))
        for (const auto v : all.ends[e]) ++begin[v + 1];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    edges.resize(begin.back());
    auto next = begin;
    for (std::uint32_t e = 0; e < all.size(); ++e)
      if (all.is_open(e))
        for (const auto v : all.ends[e]) edges[next[v]++] = e;
  }
};

// A line from a to b, and the position of points along and beside it.
struct Line {
  Vec3d a, direction;
  double length;

  Line(const Vec3& from, const Vec3& to) : a(from), direction(Vec3d(to) - a), length(glm::length(direction)) {
    direction /= length;
  }
  double along(const Vec3& p) const { return glm::dot(Vec3d(p) - a, direction); }
  double beside(const Vec3& p) const { return glm::length(glm::cross(Vec3d(p) - a, direction)); }
};

}  // namespace

double rounding_distance(std::span<const Vec3> places) {
  Bounds box;
  for (const auto& p : places) box.add(p);
  if (box.empty()) return 0.0;
  const auto far = glm::max(glm::abs(box.low), glm::abs(box.high));
  const auto size = box.size();
  return 0x1p-22 * static_cast<double>(std::max({far.x, far.y, far.z})) +
         2e-6 * static_cast<double>(std::max({size.x, size.y, size.z}));
}

TJunctions find_t_junctions(std::span<const Vec3> places, const Edges& edges, double tolerance) {
  TJunctions result;
  result.is_welded.assign(edges.size(), 0);
  const OpenFans fans(places.size(), edges);
  std::vector<std::uint32_t> loop;  // vertices of open edges
  std::vector<Vec3> points;
  for (std::uint32_t v = 0; v < places.size(); ++v)
    if (fans.begin[v + 1] > fans.begin[v]) {
      loop.push_back(v);
      points.push_back(places[v]);
    }
  const PointTree tree(points);

  std::vector<std::uint32_t> near;
  for (std::uint32_t e = 0; e < edges.size(); ++e) {
    if (!edges.is_open(e)) continue;
    const auto [a, b] = edges.ends[e];
    const Line line(places[a], places[b]);
    const auto own = edges.uses_of(e)[0].triangle;
    near.clear();
    tree.near_segment(places[a], places[b], tolerance, near);
    std::sort(near.begin(), near.end());
    for (const auto i : near) {
      const auto v = loop[i];
      const auto at = line.along(places[v]);
      if (v == a || v == b || at < tolerance || at > line.length - tolerance) continue;
      if (line.beside(places[v]) > tolerance) continue;
      bool is_junction = false;
      for (auto f = fans.begin[v]; f < fans.begin[v + 1]; ++f) {
        const auto other = fans.edges[f];
        const auto end = edges.ends[other][0] == v ? edges.ends[other][1] : edges.ends[other][0];
        if (edges.uses_of(other)[0].triangle == own || line.beside(places[end]) > tolerance) continue;
        is_junction = true;
        result.is_welded[e] = result.is_welded[other] = 1;
      }
      if (is_junction) result.found.push_back({v, e});
    }
  }
  return result;
}

}  // namespace luxel
