// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "luxel/core/context.h"
#include "luxel/patch/patch_set.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// Estimates the power that directional lamps send onto the sides that take part (all fronts, and backs of
// two-sided materials), W by band. Four shadow rays per patch and lamp: a relative standard error of about a
// thousandth where shadows are many. Zeros without such lamps. Depends on the patches alone.
std::vector<double> sun_power(const PatchSet& patches, const Tracer& tracer, const Context& context);

}  // namespace luxel
