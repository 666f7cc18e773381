// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/patch/refine_patches.h"
#include "luxel/solve/sampled.h"

namespace luxel {

// Sorts by descending weight; ties by patch. weight: [patch].
void sort_by_weight(std::span<const double> weight, std::vector<std::uint32_t>& patches);

// [patch]: 1 where the size is above the limit, else 0.
std::vector<std::uint8_t> larger_than(double limit, std::span<const double> size);

// Cuts the marked patches, or as many of those with the greatest weight as leave at most max_patches; nothing
// where none can be cut. is_marked, weight: [patch]. See refine_patches() for the cost.
std::optional<RefinedPatches> cut_within_limit(const PatchSet& patches,
                                               std::span<const std::uint8_t> is_marked,
                                               std::span<const double> weight, std::size_t max_patches,
                                               const Context& context);

// Cuts patches that are large as seen from the views, like walls beside a thousand small things (with
// ErrorMeasure::seen), and once those large in the scene. All cuts but the last replace `patches`; the last
// is returned, so that its light shows the effect of halving a patch. Cost: seen_densities() and some
// refine_patches().
RefinedPatches cut_large_patches(PatchSet& patches, ErrorMeasure measure, std::size_t max_patches,
                                 const Context& context);

}  // namespace luxel
