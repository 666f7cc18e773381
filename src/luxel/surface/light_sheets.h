// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "luxel/core/vector.h"
#include "luxel/patch/patch_set.h"
#include "luxel/patch/patch_tree.h"
#include "luxel/trace/gather_sides.h"

namespace luxel {

// The sides of one smooth surface: those on one plane, without gaps in their heights (tiles and the mortar
// below them are two), and those joined across edges that bend by less than 30 degrees. Light may run
// smoothly over a sheet, never from one sheet to another.
struct LightSheet {
  std::vector<std::uint32_t> receivers;  // ascending
  // Centroids of the patches, m, in a frame of the sheet's own. On a flat sheet the third coordinate is 0.
  std::vector<Vec3> place;   // [i], of receivers[i]
  std::vector<Vec3> normal;  // [i], unit, towards the side, in the same frame; empty on a flat sheet
  std::vector<float> area;   // [i], m²
  Vec3 low{0.0f};            // m, the smallest coordinates
  float extent = 0.0f;       // m, the longest side of the box around the centroids

  std::size_t size() const { return receivers.size(); }
  bool is_flat() const { return normal.empty(); }
};

// Every receiver is in exactly one sheet. Sheets stand in the order of their first receivers. Sides are
// joined, not patches: where windings differ, a front goes on with a back. Edges that more than two patches
// share join nothing. Cost: a sort of the edges, about 0.5 us per patch; 40 bytes per receiver.
std::vector<LightSheet> make_light_sheets(const PatchSet& patches, const PatchTree& tree,
                                          const GatherSides& sides);

}  // namespace luxel
