// SPDX-License-Identifier: Apache-2.0
#include "luxel/lamps/shadow_links.h"

#include <algorithm>
#include <cstddef>

namespace luxel {
namespace {

constexpr double join_reach = 4.0;  // in reach: lines may have been moved by twice `reach`

// A link or a part, along the way of its edge's shadow.
struct Piece {
  const EdgeShadow* shadow;
  bool is_part;
  Vec3d begin, end;
};

Piece piece_of(const EdgeShadow& s, bool is_part, const Vec3d& way) {
  const bool runs_back = glm::dot(s.ends[1] - s.ends[0], way) < 0.0;
  return {&s, is_part, s.ends[runs_back ? 1 : 0], s.ends[runs_back ? 0 : 1]};
}

// Appends those links of one edge that join parts. pieces: in order.
void add_joining(std::span<const Piece> pieces, double join, std::vector<EdgeShadow>& result) {
  std::vector<const EdgeShadow*> row;  // of links, since the last part
  const Piece* last = nullptr;         // what the next piece may continue
  for (const auto& piece : pieces) {
    const bool continues = last && glm::distance(last->end, piece.begin) <= join;
    if (!continues) row.clear();
    if (piece.is_part) {
      for (const auto* link : row) result.push_back(*link);
      row.clear();
    } else if (continues) {
      row.push_back(piece.shadow);
    }
    last = continues || piece.is_part ? &piece : nullptr;
  }
}

}  // namespace

std::vector<EdgeShadow> joining_links(std::span<const EdgeShadow> links, std::span<const EdgeShadow> parts,
                                      double reach) {
  std::vector<const EdgeShadow*> of_edges, some_parts;
  const auto by_edge = [](const EdgeShadow* a, const EdgeShadow* b) { return a->edge < b->edge; };
  for (const auto& s : links) of_edges.push_back(&s);
  for (const auto& s : parts) some_parts.push_back(&s);
  std::stable_sort(of_edges.begin(), of_edges.end(), by_edge);
  std::stable_sort(some_parts.begin(), some_parts.end(), by_edge);

  std::vector<EdgeShadow> result;
  std::vector<Piece> pieces;
  for (auto first = of_edges.begin(); first != of_edges.end();) {
    const auto last = std::upper_bound(first, of_edges.end(), *first, by_edge);
    const auto [begin, end] = std::equal_range(some_parts.begin(), some_parts.end(), *first, by_edge);
    if (begin != end) {
      const auto way = (*begin)->ends[1] - (*begin)->ends[0];
      pieces.clear();
      for (auto s = first; s != last; ++s) pieces.push_back(piece_of(**s, false, way));
      for (auto s = begin; s != end; ++s) pieces.push_back(piece_of(**s, true, way));
      std::stable_sort(pieces.begin(), pieces.end(), [&](const Piece& a, const Piece& b) {
        return glm::dot(a.begin + a.end, way) < glm::dot(b.begin + b.end, way);
      });
      add_joining(pieces, join_reach * reach, result);
    }
    first = last;
  }
  return result;
}

}  // namespace luxel
