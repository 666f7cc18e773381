// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "luxel/patch/patch_set.h"

namespace luxel {

// A vertex that lies within an edge of a patch without being one of its ends: a T-junction.
struct HangingVertex {
  std::uint32_t vertex = 0;
  std::uint32_t patch = 0;
  std::uint32_t edge = 0;  // 0 to 2: from that corner of the patch to the next
  float fraction = 0.0f;   // of the way along it, in (0, 1)
};

// Maximum distance from a line at which a vertex counts as on it, m: a ten-thousandth of `length`, which is
// invisible, plus the rounding of the coordinates.
double line_tolerance(const Vec3& vertex, double length);

// Finds, for the edges that no other patch shares, the vertices of other such edges that hang on them; sorted
// by vertex, patch and edge. Cost: a sort of the open edges.
std::vector<HangingVertex> find_hanging_vertices(const PatchSet& patches);

// Finds those on all edges among the vertices of all patches, whether light continues there or not: where a
// wall stands on a floor that is divided otherwise. Cost: a sort of the vertices, and for each edge searches
// in it.
std::vector<HangingVertex> find_all_hanging_vertices(const PatchSet& patches);

}  // namespace luxel
