// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "luxel/lamps/shadow_receivers.h"
#include "luxel/patch/patch_set.h"

namespace luxel {

// Corners of outlines that the shadows of edges leave open.
//
// Penumbras: where two edges of an outline meet, and different vertices of a lamp
// are the first (or the last) to be seen past them, the shadows of the corner from these vertices are the
// ends of two lines, and the penumbra ends between them along the shadow of the lamp's edge.
// Rounded corners: their edges are too short for lines of their own, and the lines beside them end nearer to
// each other than three of these.
//
// Returns the lines from end to end, on the triangles of both ends, each with the weight of its neighbour.
// parts: as true_parts() found them, of all triangles. Lines of four times lengths.reach or less are left
// out. Cost: two sorts.
std::vector<EdgeShadow> corner_lines(const PatchSet& triangles, std::span<const EdgeShadow> parts,
                                     const ShadowReceivers::Lengths& lengths);

}  // namespace luxel
