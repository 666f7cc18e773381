// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "luxel/core/bounds.h"
#include "luxel/patch/patch_tree.h"

namespace luxel {

// The boxes of the tree in which the solver orders patches, level by level: [level][node], m, counted from
// the patches' origin. Level 0 is the whole; a leaf that ends above stands in its own level alone. Embree's
// own hierarchy is not accessible. Cost: linear.
std::vector<std::vector<Bounds>> tree_boxes(const PatchSet& patches, const PatchTree& tree);

}  // namespace luxel
