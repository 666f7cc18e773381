// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "luxel/patch/contact_lines.h"
#include "luxel/patch/patch_set.h"
#include "luxel/scene/vertex_weld.h"

namespace luxel {

// A contact line passes over a patch, or along its edge.
struct LineOnPatch {
  std::uint32_t patch;
  std::uint32_t line;  // into the contact lines
};

// Cuts patches along contact lines, and fills PatchSet::contacts: each line becomes a chain of patch edges.
// Where a line meets an edge, all patches at that edge take the point, so that there are no T-vertices and
// closed meshes stay closed. The fragments are Delaunay within their patch, and they stand in its place;
// their areas sum to the patch's but for rounding. A fragment that floats give no area at all is left out.
// Patches that no line meets stay as they are.
//
// Several hundred lines that cross on one patch would make a hundred thousand: a patch that would add more
// than `max_added` with those before it gets no cuts in its inside. Returns the number of such patches.
//
// The vertices of `patches` are those of the weld, to which new ones are added. on: sorted by patch.
std::size_t cut_along_contacts(PatchSet& patches, VertexWeld& weld, std::span<const ContactLine> lines,
                               std::span<const LineOnPatch> on, std::size_t max_added);

}  // namespace luxel
