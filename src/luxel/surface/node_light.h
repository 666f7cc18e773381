// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "luxel/core/context.h"
#include "luxel/patch/patch_set.h"
#include "luxel/surface/side_light.h"
#include "luxel/surface/side_nodes.h"

namespace luxel {

// The irradiance at every node, [node][band], W/m², whose linear interpolation approximates the patches'
// means: least squares with a consistent mass matrix, stopped early.
//
// 1. Each side has a linear function of its own (SideSlopes); a node begins with their mean, weighed by area
//    (Oswald 1993): right for linear light at every vertex.
// 2. A few times, what the means over the sides still lack is given to their nodes (Landweber 1951). That
//    sharpens what step 1 has smoothed, peaks and the edges of shadows.
// 3. No node is beyond the values that its sides have, as their means and by their linear functions there; so
//    inside a surface none is beyond the patches of two rings around it. None is negative.
// 4. A vertex that hangs on an edge (a T-junction) takes what runs along that edge, so that no seam shows.
//    Where the ends of the edge hang themselves nothing is forced; the fits know of each other.
//
// Linear time; the same bits on any number of threads.
std::vector<float> light_of_nodes(const PatchSet& patches, const SideLight& light, const SideNodes& nodes,
                                  const Context& context);

}  // namespace luxel
