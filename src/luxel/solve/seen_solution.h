// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/core/workers.h"
#include "luxel/patch/patch_set.h"
#include "luxel/solution/solution.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// The seen error of a solution (Solution::seen_error) from its light and the standard errors of its sides,
// with the same views as a solve of these patches has. widening: of the standard errors, see Solution; from
// error_degrees_of_freedom where that is above 0, else 1. 0 where the solution states no standard errors, or
// no open space is found. Cost: that of place_views().
double seen_error_of(const PatchSet& patches, const Tracer& tracer, const Solution& solution,
                     const Workers& workers);

}  // namespace luxel
