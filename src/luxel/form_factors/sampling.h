// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "luxel/form_factors/element_rays.h"
#include "luxel/form_factors/sample_view_factors.h"

namespace luxel {

// The two ways of sample_view_factors(), which has the promises.

// Between patches: rows are made once, with as many rays as some of them, tried before, say is enough.
std::optional<ViewFactors> sample_patch_factors(const ElementRays& rays, const SampleFactorsOptions& options,
                                                const Workers& workers, const Monitor& monitor,
                                                SampleFactorsReport& report);
// Between elements of many patches: sums over rays, which are doubled.
std::optional<ViewFactors> sample_group_factors(const ElementRays& rays, const SampleFactorsOptions& options,
                                                const Workers& workers, const Monitor& monitor,
                                                SampleFactorsReport& report);

// Rays a side and replicate that a limit allows, a power of two; where there is none, the most there can be.
std::uint32_t max_per_replicate(const SampleFactorsOptions& options);

// Receivers [begin, end) as a list.
std::vector<std::uint32_t> receiver_list(std::size_t begin, std::size_t end);

// Bytes that so many factors take at most at one time, counted or afterwards. with_reverse: how many there
// are once those are listed both ways that were found one way.
double bytes_of_factors(double counted, double with_reverse, const SampleFactorsOptions& options);

// Throws InputError where so many factors take more than the memory allowed; else notes what they take.
void predict(double counted, double with_reverse, const SampleFactorsOptions& options,
             SampleFactorsReport& report);

}  // namespace luxel
