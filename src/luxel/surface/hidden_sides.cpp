// SPDX-License-Identifier: Apache-2.0
#include "luxel/surface/hidden_sides.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "luxel/core/disjoint_sets.h"
#include "luxel/patch/side.h"
#include "luxel/surface/hidden_light.h"
#include "luxel/trace/place_views.h"

namespace luxel {
namespace {

// [side]: neither lit nor shining. Sides that absorb all light and are not drawn do not count.
std::vector<std::uint8_t> unlit_sides(const PatchSet& patches, const Solution& solution) {
  const auto bands = patches.band_count();
  const auto hardly_lit = hidden_irradiance(patches, solution);
  std::vector<std::uint8_t> is_unlit(side_count(patches.size()), 0);
  for (std::uint32_t p = 0; p < patches.size(); ++p)
    for (const bool back : {false, true}) {
      if (back && !patches.material_of(p).two_sided) continue;
      double irradiance = 0.0, emittance = 0.0;
      for (std::size_t b = 0; b < bands; ++b) {
        irradiance += static_cast<double>(solution.irradiance.of(back)[p * bands + b]);
        if (!back) emittance += static_cast<double>(patches.emittance(p, b));
      }
      is_unlit[SideId(p, back).index()] = irradiance <= hardly_lit && emittance == 0.0 ? 1 : 0;
    }
  return is_unlit;
}

// Sets of unlit sides that continue into each other across edges, whichever side the winding calls them. An
// edge at which solids touch joins nothing: there the inside of one would be joined to the outside of
// another.
DisjointSets joined_sides(const PatchSet& patches, const std::vector<std::uint8_t>& is_unlit) {
  struct Edge {
    std::uint32_t low, high, patch;
    bool rises;  // from low to high, as the patch is wound
  };
  std::vector<Edge> edges;
  edges.reserve(3 * patches.size());
  for (std::uint32_t p = 0; p < patches.size(); ++p)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto a = patches.corners[p][k], b = patches.corners[p][(k + 1) % 3];
      edges.push_back({std::min(a, b), std::max(a, b), p, a < b});
    }
  const auto ends = [](const Edge& e) { return std::pair(e.low, e.high); };
  std::sort(edges.begin(), edges.end(), [&](const Edge& a, const Edge& b) { return ends(a) < ends(b); });
  DisjointSets joined(is_unlit.size());
  for (std::size_t i = 0, end = 0; i < edges.size(); i = end) {
    while (end < edges.size() && ends(edges[end]) == ends(edges[i])) ++end;
    if (end - i != 2) continue;
    const auto &a = edges[i], &b = edges[i + 1];
    for (const bool back : {false, true}) {
      const auto one = SideId(a.patch, back).index();
      const auto other = SideId(b.patch, back != (a.rises == b.rises)).index();
      if (is_unlit[one] != 0 && is_unlit[other] != 0)
        joined.join(static_cast<std::uint32_t>(one), static_cast<std::uint32_t>(other));
    }
  }
  return joined;
}

}  // namespace

FrontAndBack<std::uint8_t> hidden_sides(const PatchSet& patches, const Solution& solution,
                                        const Tracer& tracer, const Context& context) {
  FrontAndBack<std::uint8_t> hidden;
  for (const bool back : {false, true}) hidden.of(back).assign(patches.size(), 0);
  if (patches.focuses_on_cameras || !patches.focus.empty()) return hidden;
  const auto sets = place_views(patches, tracer, context);
  if (sets.empty()) return hidden;

  const auto is_unlit = unlit_sides(patches, solution);
  auto joined = joined_sides(patches, is_unlit);
  std::vector<std::uint8_t> is_seen(is_unlit.size(), 0);  // [side that stands for its set]
  for (const auto* views : {&sets.dealing, &sets.stating})
    for (const auto side : views->sides)
      if (is_unlit[side.index()] != 0) is_seen[joined.of(static_cast<std::uint32_t>(side.index()))] = 1;
  for (std::uint32_t s = 0; s < is_unlit.size(); ++s)
    if (is_unlit[s] != 0 && is_seen[joined.of(s)] == 0) hidden.of(SideId::at(s))[SideId::at(s).patch()] = 1;
  return hidden;
}

}  // namespace luxel
