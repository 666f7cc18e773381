// SPDX-License-Identifier: Apache-2.0
#include "luxel/scene/edges.h"

#include <algorithm>
#include <numeric>

namespace luxel {
namespace {

struct Side {
  std::uint32_t high = 0;
  Edges::Use use;
};

}  // namespace

Edges find_edges(std::span<const CleanTriangle> triangles, std::size_t vertices) {
  // A counting sort of the sides by their lower vertex leaves short runs to sort.
  std::vector<std::uint32_t> begin(vertices + 1, 0);
  for (const auto& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) ++begin[std::min(t.corners[k], t.corners[(k + 1) % 3]) + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<Side> sides(3 * triangles.size());
  auto next = begin;
  for (std::uint32_t i = 0; i < triangles.size(); ++i)
    for (std::uint8_t k = 0; k < 3; ++k) {
      const auto a = triangles[i].corners[k];
      const auto b = triangles[i].corners[(k + 1u) % 3u];
      sides[next[std::min(a, b)]++] = {std::max(a, b), {i, k, a < b}};
    }

  Edges edges;
  edges.uses.reserve(sides.size());
  edges.ends.reserve(sides.size() / 2);
  edges.begin.reserve(sides.size() / 2 + 1);
  for (std::uint32_t low = 0; low < vertices; ++low) {
    const auto first = sides.begin() + begin[low];
    const auto last = sides.begin() + begin[low + 1];
    std::sort(first, last, [](const Side& a, const Side& b) {
      return a.high != b.high ? a.high < b.high : a.use.triangle < b.use.triangle;
    });
    for (auto side = first; side != last; ++side) {
      if (side == first || side->high != (side - 1)->high) {
        edges.ends.push_back({low, side->high});
        edges.begin.push_back(static_cast<std::uint32_t>(edges.uses.size()));
      }
      edges.uses.push_back(side->use);
    }
  }
  edges.begin.push_back(static_cast<std::uint32_t>(edges.uses.size()));
  return edges;
}

}  // namespace luxel
