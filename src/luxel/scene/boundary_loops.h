// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "luxel/core/bounds.h"
#include "luxel/scene/t_junctions.h"

namespace luxel {

// Open edges that hang together by their vertices: the loop of a sheet, of a hole, of a missing ceiling.
struct BoundaryLoop {
  std::vector<std::uint32_t> edges;  // rising
  Bounds box;                        // m
  double length = 0.0;               // m
  Vec3 centre{0.0f};                 // of its edges by length, m
};

// Finds the loops of the open edges that are not welded, ordered by their first edge. Nearly linear.
std::vector<BoundaryLoop> find_boundary_loops(std::span<const Vec3> places, const Edges& edges,
                                              const TJunctions& junctions);

}  // namespace luxel
