// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "luxel/patch/patch_set.h"
#include "luxel/patch/side.h"

namespace luxel {

struct SideNodes;

// An edge where two sides meet that face alike, or the part of one between vertices that hang on it.
struct SideEdge {
  // The edge in one of the sides: an edge of the patch, from corner `edge` to the next, and where on it the
  // two ends lie, as fractions of the way. Both halves name the ends in the same order.
  struct Half {
    SideId side;
    std::uint32_t edge = 0;
    float from = 0.0f, to = 1.0f;
  };
  std::array<Half, 2> halves;
  std::array<std::uint32_t, 2> ends{};  // vertices
  bool smooth = false;                  // light runs on across it; else it may jump there
};

// Finds all, sorted by their ends. Light is continuous where both sides have the same nodes at both ends (see
// SideNodes) and no other surface touches the edge on the side they face. Cost: a sort of the edges.
std::vector<SideEdge> find_side_edges(const PatchSet& patches, const SideNodes& nodes);

}  // namespace luxel
