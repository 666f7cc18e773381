// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "luxel/patch/patch_set.h"
#include "luxel/trace/tracer.h"

namespace luxel::bench {

// Orders of the same rays.
enum class RayOrder {
  coherent,  // groups of 256 neighbouring patches (Morton order); in each, stratum by stratum of directions
  by_patch,  // neighbouring patches one after another, each with its rays in all directions
  shuffled
};

// 64 rays into the cosine hemisphere over the front of each patch, one a stratum (8 x 8); of larger scenes
// only as many groups of neighbours, evenly spread, as give about `most` rays (at least 1).
std::vector<Ray> gather_rays(const PatchSet& patches, RayOrder order, std::size_t most);

}  // namespace luxel::bench
