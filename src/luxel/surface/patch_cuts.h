// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "luxel/patch/patch_set.h"

namespace luxel {

// A point on the border of a patch: a corner, or a vertex of other patches that lies within an edge.
struct BorderVertex {
  std::uint32_t vertex = 0;  // index into PatchSet::vertices
  std::uint32_t edge = 0;    // 0 to 2: it lies from that corner of the patch to the next
  float fraction = 0.0f;     // of the way along it; 0: the corner itself
  bool is_corner() const { return fraction == 0.0f; }
  // Barycentric coordinates in the patch.
  Vec3 weights() const;
};

// A patch that is cut into triangles so that every vertex on its border is a corner.
struct PatchCut {
  std::uint32_t patch = 0;
  std::vector<BorderVertex> points;                     // in the winding of the patch
  std::vector<std::array<std::uint32_t, 3>> triangles;  // indices of points; none where it has no area
};

// Finds the cuts that close the T-junctions of a mesh: rasterised, its edges would round differently from the
// vertices on them, and the background would show through. In order of patches, only those that have a vertex
// of another patch within an edge, as find_all_hanging_vertices() has it: also where a block stands on a
// floor that is divided otherwise. Cost: as for that function.
std::vector<PatchCut> cut_at_hanging_vertices(const PatchSet& patches);

}  // namespace luxel
