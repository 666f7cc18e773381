// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "luxel/core/context.h"
#include "luxel/form_factors/element_rays.h"
#include "luxel/form_factors/sample_view_factors.h"

namespace luxel {

// The two algorithms of sample_view_factors(), which documents them.

// For factors between patches: rows are computed once, with a number of rays that a trial on some of them
// estimates.
std::optional<ViewFactors> sample_patch_factors(const ElementRays& rays, const SampleFactorsOptions& options,
                                                SampleFactorsReport& report, const Context& context);
// Between elements of many patches: sums over rays, which are doubled.
std::optional<ViewFactors> sample_group_factors(const ElementRays& rays, const SampleFactorsOptions& options,
                                                SampleFactorsReport& report, const Context& context);

// Returns the rays per side and replicate that a limit allows, a power of two; without a limit, the maximum.
std::uint32_t max_per_replicate(const SampleFactorsOptions& options);

// Receivers [begin, end) as a list.
std::vector<std::uint32_t> receiver_list(std::size_t begin, std::size_t end);

// Returns the peak memory of this many factors, in bytes, while they are computed or afterwards.
// with_reverse: the number of factors once those found in one direction are listed in both.
double bytes_of_factors(double counted, double with_reverse, const SampleFactorsOptions& options);

// Throws InputError where this many factors exceed the memory allowed; else records their memory.
void predict(double counted, double with_reverse, const SampleFactorsOptions& options,
             SampleFactorsReport& report);

}  // namespace luxel
