// SPDX-License-Identifier: Apache-2.0
#include "luxel/scene/rims.h"

#include "luxel/core/disjoint_sets.h"

namespace luxel {
namespace {

constexpr auto none = 0xffffffffu;

}  // namespace

std::vector<Rim> find_rims(std::span<const Vec3> places, const Edges& edges, const TJunctions& junctions) {
  const auto counts = [&](std::size_t e) { return edges.is_open(e) && junctions.is_sewn[e] == 0; };
  DisjointSets sets(places.size());
  for (std::size_t e = 0; e < edges.size(); ++e)
    if (counts(e)) sets.join(edges.ends[e][0], edges.ends[e][1]);

  std::vector<Rim> rims;
  std::vector<Vec3d> sums;  // of the middles of edges, by length
  std::vector<std::uint32_t> rim_of(places.size(), none);
  for (std::uint32_t e = 0; e < edges.size(); ++e) {
    if (!counts(e)) continue;
    auto& number = rim_of[sets.of(edges.ends[e][0])];
    if (number == none) {
      number = static_cast<std::uint32_t>(rims.size());
      rims.emplace_back();
      sums.emplace_back(0.0);
    }
    auto& rim = rims[number];
    const auto& a = places[edges.ends[e][0]];
    const auto& b = places[edges.ends[e][1]];
    const auto length = glm::length(Vec3d(b) - Vec3d(a));
    rim.edges.push_back(e);
    rim.box.add(a);
    rim.box.add(b);
    rim.length += length;
    sums[number] += 0.5 * length * (Vec3d(a) + Vec3d(b));
  }
  for (std::size_t r = 0; r < rims.size(); ++r) rims[r].centre = Vec3(sums[r] / rims[r].length);
  return rims;
}

}  // namespace luxel
