// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/patch/patch_set.h"
#include "luxel/trace/gather_sides.h"
#include "luxel/trace/tracer.h"

namespace luxel::bench {

// The fronts: in a closed room no light reaches the backs, and the solver leaves them out.
GatherSides fronts_of(const PatchSet& patches, const Context& context);

// Orders of the same rays.
enum class RayOrder {
  traced,    // of the sampled operator, on one thread
  by_patch,  // neighbouring patches one after another, each with its rays in all directions
  shuffled
};

// The rays of a sampled operator's first round: this number for each replicate and side. Larger scenes use
// only some groups of jointly traced rays, evenly spread, for about `most` rays (at least one group).
struct GatherRound {
  std::uint32_t replicates = 8, per_receiver = 8;
  std::size_t most = 1u << 31;
};
std::vector<Ray> gather_rays(const PatchSet& patches, const GatherSides& sides, const GatherRound& round,
                             RayOrder order);

}  // namespace luxel::bench
