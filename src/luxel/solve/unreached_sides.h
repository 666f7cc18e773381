// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "luxel/core/workers.h"
#include "luxel/patch/patch_set.h"
#include "luxel/solution/solution.h"
#include "luxel/solve/hit_store.h"

namespace luxel {

// Which receivers any light reaches, as far as its rays so far can tell: lamps, those that have
// light in a first picture or direct light, those whose rays meet the sky or such a receiver, and so on; and
// the neighbours of these. 1 for lit. The outside of a house is dark, and need not be sampled.
std::vector<std::uint8_t> lit_receivers(const PatchSet& patches, const HitStore& hits,
                                        const Solution& first_picture,
                                        std::span<const std::vector<float>> direct, const Workers& workers);

}  // namespace luxel
