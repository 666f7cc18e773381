// SPDX-License-Identifier: Apache-2.0
#include "luxel/scene/boundary_loops.h"

#include "luxel/core/disjoint_sets.h"
#include "luxel/core/none.h"

namespace luxel {
namespace {}  // namespace

std::vector<BoundaryLoop> find_boundary_loops(std::span<const Vec3> places, const Edges& edges,
                                              const TJunctions& junctions) {
  const auto counts = [&](std::size_t e) { return edges.is_open(e) && junctions.is_welded[e] == 0; };
  DisjointSets sets(places.size());
  for (std::size_t e = 0; e < edges.size(); ++e)
    if (counts(e)) sets.join(edges.ends[e][0], edges.ends[e][1]);

  std::vector<BoundaryLoop> loops;
  std::vector<Vec3d> sums;  // of the middles of edges, by length
  std::vector<std::uint32_t> loop_of(places.size(), none);
  for (std::uint32_t e = 0; e < edges.size(); ++e) {
    if (!counts(e)) continue;
    auto& number = loop_of[sets.of(edges.ends[e][0])];
    if (number == none) {
      number = static_cast<std::uint32_t>(loops.size());
      loops.emplace_back();
      sums.emplace_back(0.0);
    }
    auto& loop = loops[number];
    const auto& a = places[edges.ends[e][0]];
    const auto& b = places[edges.ends[e][1]];
    const auto length = glm::length(Vec3d(b) - Vec3d(a));
    loop.edges.push_back(e);
    loop.box.add(a);
    loop.box.add(b);
    loop.length += length;
    sums[number] += 0.5 * length * (Vec3d(a) + Vec3d(b));
  }
  for (std::size_t r = 0; r < loops.size(); ++r) loops[r].centre = Vec3(sums[r] / loops[r].length);
  return loops;
}

}  // namespace luxel
