// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "luxel/core/workers.h"
#include "luxel/patch/patch_set.h"
#include "luxel/solve/sampled_operator.h"

namespace luxel {

// The part of the squared error sum of I_i Var H_i that each receiver's gather rays answer for: its rays per
// area times what one more is worth, both to its own row and to the rows of those that it meets
// (SampledOperator::ray_worth). Doubling a receiver's rays takes about half of its part off. Parts are of the
// rays' densities and the light that they see, not of what a receiver's own rays happened to find; so counts
// that follow them do not follow luck, which would bias the light.
//
// begins: units of neighbouring receivers, which are taken to see alike. importance: I, [receiver].
// radiosity: of CrossedHalves. gathered: [receiver * bands + band]. whole: the sum of the result. Cost: two
// look-ups per ray.
std::vector<double> gather_errors(const PatchSet& patches, const SampledOperator& transport,
                                  std::span<const std::uint32_t> begins, std::span<const double> importance,
                                  std::span<const float> radiosity, std::span<const float> gathered,
                                  double whole, const Workers& workers);

}  // namespace luxel
