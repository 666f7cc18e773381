// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "luxel/lamps/sky_box.h"
#include "luxel/patch/patch_set.h"
#include "luxel/patch/side.h"

namespace luxel {

// Power of the patch sides that have any. The others are not listed, so that a bounce costs no more than the
// sides it meets, however many there are. After the sides come the faces of the sky.
struct SidePower {
  // Rising; at side_count(patches) + f stands face f of the SkyBox.
  std::vector<SideId> side;
  std::vector<double> watts;  // [entry][band], none negative
};

// Returns the power emitted by the lamps: the fronts of all patches that emit.
SidePower lamp_power(const PatchSet& patches);

// Adds the power of the sky through the faces of its box; all sides must have been added before.
void add_sky_power(const PatchSet& patches, const SkyBox& box, SidePower& power);

// The entries of a rising list of sides that lie in [begin, end).
struct EntryRange {
  std::size_t begin = 0, end = 0;
};
EntryRange entries_between(std::span<const SideId> side, SideId begin, SideId end);

}  // namespace luxel
