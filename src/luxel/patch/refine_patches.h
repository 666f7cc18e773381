// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/patch/patch_set.h"

namespace luxel {

struct RefinedPatches {
  PatchSet patches;
  std::vector<std::uint32_t> parent;  // [patch]: the patch of the old set that it is, or is a part of
};

// Returns whether a patch is a part of one that was cut, whose other parts stand beside it.
inline bool is_part(std::span<const std::uint32_t> parent, std::size_t patch) {
  return (patch > 0 && parent[patch - 1] == parent[patch]) ||
         (patch + 1 < parent.size() && parent[patch + 1] == parent[patch]);
}

// Cuts the marked patches in four: all three edges are halved, the longest one first (Rivara 1984, the
// four-triangle partition), so that angles do not degrade over any number of refinements. Edges shorter than
// 0.4 of the longest stay: needles are cut in three, and their parts are wider for their length. A neighbour
// at a halved edge is cut there too, and at its own longest edge, so that refinement adds no T-junctions: no
// vertex lies within another patch's edge that did not before. A needle between patches of its plane is cut
// at both long edges, as light goes on across it: so both neighbours have the vertex. Edges at the resolution
// of floats are not cut.
//
// is_marked: [patch]. Unaffected patches keep their place in the order; parts take the place of the whole
// patch. Contacts are inherited by the halves of their edge. Cost: a sort of the edges, about half a second
// per million patches.
RefinedPatches refine_patches(const PatchSet& patches, std::span<const std::uint8_t> is_marked,
                              const Context& context = Context());

}  // namespace luxel
