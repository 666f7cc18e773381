// SPDX-License-Identifier: Apache-2.0
#include "luxel/surface/side_nodes.h"

#include <algorithm>

#include "luxel/patch/side.h"
#include "luxel/surface/one_ring.h"

namespace luxel {
namespace {

constexpr std::size_t vertices_per_chunk = 4096;
constexpr std::uint32_t begins_node = 0x80000000u;  // in Member::place, until nodes are numbered

// The corners (3 * patch + corner) at each vertex, in rows: row v is corners[begin[v]] to
// corners[begin[v+1]].
struct CornersOfVertex {
  std::vector<std::size_t> begin;
  std::vector<std::uint32_t> corners;

  std::span<const std::uint32_t> at(std::size_t vertex) const {
    return std::span(corners).subspan(begin[vertex], begin[vertex + 1] - begin[vertex]);
  }
};

CornersOfVertex corners_of_vertices(const PatchSet& patches) {
  CornersOfVertex rows;
  rows.begin.assign(patches.vertices.size() + 1, 0);
  for (const auto& patch : patches.corners)
    for (const auto v : patch) ++rows.begin[v + 1];
  for (std::size_t v = 0; v < patches.vertices.size(); ++v) rows.begin[v + 1] += rows.begin[v];

  auto next = rows.begin;
  rows.corners.resize(3 * patches.size());
  for (std::uint32_t c = 0; c < rows.corners.size(); ++c)
    rows.corners[next[patches.corners[c / 3][c % 3]]++] = c;
  return rows;
}

// Lays out the sides of one ring, surface by surface.
class Surfaces {
 public:
  // Ranks surfaces in the order of their names; returns their number.
  std::uint32_t rank(const OneRing& ring) {
    rank_.resize(2 * ring.size());
    place_.clear();
    for (std::size_t i = 0; i < rank_.size(); ++i) {
      const auto of_ring = SideId::at(i);
      const auto name = ring.surface(of_ring.patch(), of_ring.is_back());
      if (name == i) place_.push_back(0);
      rank_[i] = name == i ? static_cast<std::uint32_t>(place_.size() - 1) : rank_[name];
      ++place_[rank_[i]];
    }
    return static_cast<std::uint32_t>(place_.size());
  }
  // first_hanging: index of the ring's first hanging member; out: 2 * ring.size().
  void lay_out(const OneRing& ring, std::size_t first_hanging, SideNodes::Member* out) {
    std::uint32_t next = 0;
    for (auto& place : place_) {
      const auto count = place;
      place = next;
      next += count;
      out[place].place = begins_node;
    }
    for (std::size_t s = 0; s < rank_.size(); ++s) {
      const auto of_ring = SideId::at(s);
      const auto i = of_ring.patch();
      auto& member = out[place_[rank_[s]]++];
      member.side = {ring.patch(i), of_ring.is_back()};
      member.place |= ring.is_hanging(i)
                          ? static_cast<std::uint32_t>(3 + first_hanging + i - ring.corner_count())
                          : ring.corner(i);
    }
  }

 private:
  std::vector<std::uint32_t> rank_;   // [side of a member of the ring]
  std::vector<std::uint32_t> place_;  // [rank]
};

}  // namespace

std::span<const SideNodes::Visit> SideNodes::visited_by(SideId side) const {
  const auto [a, b] = std::equal_range(visits.begin(), visits.end(), Visit{side, 0},
                                       [](const Visit& x, const Visit& y) { return x.side < y.side; });
  return {a, b};
}

SideNodes make_side_nodes(const PatchSet& patches, float cos_crease, const Context& context) {
  const auto vertices = patches.vertices.size();
  const auto rows = corners_of_vertices(patches);
  SideNodes nodes;
  nodes.hanging = find_hanging_vertices(patches);
  nodes.members.resize(2 * (rows.corners.size() + nodes.hanging.size()));
  nodes.of_side.resize(side_count(patches.size()));
  nodes.first.assign(vertices + 1, 0);
  const auto hanging_before = [&](std::size_t vertex) {
    return static_cast<std::size_t>(
        std::lower_bound(nodes.hanging.begin(), nodes.hanging.end(), vertex,
                         [](const HangingVertex& h, std::size_t v) { return h.vertex < v; }) -
        nodes.hanging.begin());
  };

  // 1. Each vertex independently.
  context.for_chunks(vertices, vertices_per_chunk, [&](std::size_t begin, std::size_t end, int) {
    OneRing ring(patches, cos_crease);
    Surfaces surfaces;
    auto h = hanging_before(begin);
    for (auto v = begin; v < end; ++v) {
      const auto first = h;
      while (h < nodes.hanging.size() && nodes.hanging[h].vertex == v) ++h;
      ring.fill(rows.at(v), std::span(nodes.hanging).subspan(first, h - first));
      nodes.first[v + 1] = surfaces.rank(ring);
      surfaces.lay_out(ring, first, nodes.members.data() + 2 * (rows.begin[v] + first));
    }
  });

  // 2. Numbers for all nodes.
  for (std::size_t v = 0; v < vertices; ++v) nodes.first[v + 1] += nodes.first[v];
  nodes.begin.assign(nodes.first[vertices] + std::size_t{1}, nodes.members.size());
  context.for_chunks(vertices, vertices_per_chunk, [&](std::size_t begin, std::size_t end, int) {
    auto node = nodes.first[begin];
    const auto last = 2 * (rows.begin[end] + hanging_before(end));
    for (auto i = 2 * (rows.begin[begin] + hanging_before(begin)); i < last; ++i) {
      auto& member = nodes.members[i];
      if (member.place & begins_node) nodes.begin[node++] = i;
      member.place &= ~begins_node;
      if (member.place < 3) nodes.of_side[member.side.index()][member.place] = node - 1;
    }
  });

  if (nodes.hanging.empty()) return nodes;
  for (std::uint32_t node = 0; node < nodes.size(); ++node)
    for (const auto& member : nodes.at(node))
      if (member.place >= 3) nodes.visits.push_back({member.side, node});
  std::stable_sort(nodes.visits.begin(), nodes.visits.end(),
                   [](const auto& a, const auto& b) { return a.side < b.side; });
  return nodes;
}

}  // namespace luxel
