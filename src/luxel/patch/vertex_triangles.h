// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "luxel/scene/clean_triangles.h"

namespace luxel {

// The triangles that meet at each vertex. Keeps a reference to them. 12 bytes per triangle and 8 per vertex.
// Thread-safe.
class VertexTriangles {
 public:
  VertexTriangles(const std::vector<CleanTriangle>& triangles, std::size_t vertices)
      : triangles_(triangles), begin_(vertices + 1, 0), at_(3 * triangles.size()) {
    for (const auto& t : triangles)
      for (const auto v : t.corners) ++begin_[v + 1];
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    auto next = begin_;
    for (std::uint32_t i = 0; i < triangles.size(); ++i)
      for (const auto v : triangles[i].corners) at_[next[v]++] = i;
  }

  // Returns whether ask(third vertex) is true for a triangle other than `but` that has both vertices. Cost:
  // the triangles at the vertex that has fewer; thousands meet at the hub of a fan.
  template <typename Ask>
  bool any_across(std::uint32_t a, std::uint32_t b, std::uint32_t but, Ask ask) const {
    return any_at_edge(a, b, but, [&](std::uint32_t, std::uint32_t apex) { return ask(apex); });
  }

  // The same with ask(triangle, third vertex).
  template <typename Ask>
  bool any_at_edge(std::uint32_t a, std::uint32_t b, std::uint32_t but, Ask ask) const {
    if (begin_[b + 1] - begin_[b] < begin_[a + 1] - begin_[a]) std::swap(a, b);
    for (auto i = begin_[a]; i < begin_[a + 1]; ++i) {
      const auto t = at_[i];
      if (t == but) continue;
      const auto& c = triangles_[t].corners;
      if (c[0] != b && c[1] != b && c[2] != b) continue;
      if (ask(t, c[0] != a && c[0] != b ? c[0] : (c[1] != a && c[1] != b ? c[1] : c[2]))) return true;
    }
    return false;
  }

 private:
  const std::vector<CleanTriangle>& triangles_;
  std::vector<std::size_t> begin_;
  std::vector<std::uint32_t> at_;
};

}  // namespace luxel
