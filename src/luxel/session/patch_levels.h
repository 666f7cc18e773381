// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "luxel/patch/patch_set.h"

namespace luxel {

// Number of halvings of the input triangle that gave each patch, [patch]: the nearest whole number to log2 of
// their areas' ratio. 0: not cut. Cuts along contacts make parts that are no halves.
std::vector<std::uint8_t> patch_levels(const PatchSet& patches);

// Longest edge of each patch, m, [patch].
std::vector<float> patch_sizes(const PatchSet& patches);

}  // namespace luxel
