// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/patch/patch_set.h"
#include "luxel/patch/side.h"
#include "luxel/surface/hanging_vertices.h"

namespace luxel {

// Nodes at which the light of patch sides is continuous: one for each vertex and each smooth surface that
// meets there (see OneRing).
struct SideNodes {
  // A side at a node: with a corner of its patch (0 to 2), or with a place on an edge (3 + index in hanging).
  struct Member {
    SideId side;
    std::uint32_t place = 0;
  };
  struct Visit {
    SideId side;
    std::uint32_t node = 0;
  };

  std::vector<std::array<std::uint32_t, 3>> of_side;  // [side]: the nodes of its three corners
  std::vector<Member> members;                        // those of node n: [begin[n], begin[n + 1])
  std::vector<std::size_t> begin;                     // [node], and the end
  std::vector<std::uint32_t> first;                   // [vertex]: its first node; and the end
  std::vector<HangingVertex> hanging;
  std::vector<Visit> visits;  // nodes that lie on an edge of a side, sorted by side

  std::size_t size() const { return begin.size() - 1; }
  std::span<const Member> at(std::size_t node) const {
    return std::span(members).subspan(begin[node], begin[node + 1] - begin[node]);
  }
  std::span<const Visit> visited_by(SideId side) const;
};

// Nodes stand in the order of their vertices. cos_crease: cosine of the crease angle. The same nodes on any
// number of threads; linear but for a sort of the few patches at each vertex, and of T-junctions.
SideNodes make_side_nodes(const PatchSet& patches, float cos_crease, const Context& context);

}  // namespace luxel
