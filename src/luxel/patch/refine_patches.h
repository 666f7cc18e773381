// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "luxel/core/workers.h"
#include "luxel/patch/patch_set.h"

namespace luxel {

struct RefinedPatches {
  PatchSet patches;
  std::vector<std::uint32_t> parent;  // [patch]: the patch of the old set that it is, or is a part of
};

// Cuts the marked patches in four: all three edges are halved, the longest one first (Rivara 1984, the
// four-triangle partition), which keeps angles from degrading however often it is done. A neighbour at a
// halved edge is cut there too, and at its own longest edge, so surfaces stay whole: no vertex lies within
// another patch's edge that did not before. An edge as short as floats can tell stays.
//
// is_marked: [patch]. Patches that nothing touches keep their place in the order; parts stand where the whole
// one stood. Contacts are inherited by the halves of their edge. Cost: a sort of the edges, about half a
// second a million patches.
RefinedPatches refine_patches(const PatchSet& patches, std::span<const std::uint8_t> is_marked,
                              const Workers& workers = Workers());

}  // namespace luxel
