// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "luxel/patch/patch_set.h"
#include "luxel/patch/patch_tree.h"
#include "luxel/patch/side.h"

namespace luxel {

// Positions that share one scrambled sequence. A sequence over all of them has less noise in sums over many
// sides, but then its error is common to the whole scene: two replicates whose first scrambled bits agree
// were correlated by up to 0.39 in every side, whereas error bars require independent replicates.
inline constexpr std::uint32_t sequence_positions = 64;

// The patch sides that gather light, each in its receiver: fronts in the tree's order, then backs in the
// same.
struct GatherSides {
  std::vector<SideId> side;                     // [receiver]
  std::vector<std::uint32_t> position;          // [receiver], see PatchTree
  std::vector<std::uint32_t> receiver_of_side;  // [side]; none: does not gather
  std::size_t fronts = 0;                       // receivers [0, fronts) are fronts

  std::size_t size() const { return side.size(); }
};

// Every front, and the back of every patch whose material is two-sided.
GatherSides all_gather_sides(const PatchSet& patches, const PatchTree& tree);

// Begin of each group of neighbouring receivers, and at the end the number of receivers. A group holds the
// receivers of one block of positions, all fronts or all backs.
std::vector<std::uint32_t> neighbour_begins(const GatherSides& sides, std::uint32_t positions);

// Those receivers of `sides` that are kept, closed up.
GatherSides restored_gather_sides(const GatherSides& sides, const std::vector<std::uint8_t>& keep);

}  // namespace luxel
