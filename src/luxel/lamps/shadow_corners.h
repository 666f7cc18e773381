// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "luxel/lamps/shadow_receivers.h"
#include "luxel/patch/patch_set.h"

namespace luxel {

// Closes the lines of shadows at corners of outlines, where the shadows of edges leave them open:
// - Penumbras. Different vertices of a lamp may be the first, or the last, to be seen past two edges that
//   meet. The shadows of the corner from these vertices are then the ends of two lines, and the penumbra ends
//   between them along the shadow of the lamp's edge.
// - Blunt corners. Their edges are too short for lines of their own (shortest_shadow), and the lines beside
//   them end nearer to each other than three times that.
//
// Returns lines from end to end, on the triangles of both ends, each with the weight of its neighbour. parts:
// as true_parts() found them, of all triangles. Lines of four times lengths.reach or less are left out. Cost:
// sorts.
std::vector<EdgeShadow> corner_lines(const PatchSet& triangles, std::span<const EdgeShadow> parts,
                                     const ShadowReceivers::Lengths& lengths);

}  // namespace luxel
