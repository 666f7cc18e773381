// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "luxel/classical/method_options.h"
#include "luxel/core/context.h"
#include "luxel/patch/patch_set.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// Estimated from a few form factors, hemicubes or lines that are computed and timed, half a second or a
// little more, and from the decay of light at the mean reflectance. Accurate to a factor of two or three:
// meant to distinguish minutes from days. Depends on the machine and its load.
Forecast forecast_dense(const PatchSet& patches, const Tracer& tracer, const DenseSolveOptions& options,
                        const Context& context);
Forecast forecast_hemicube(const PatchSet& patches, const HemicubeSolveOptions& options,
                           const Context& context);
Forecast forecast_lines(const PatchSet& patches, const Tracer& tracer, const LinesSolveOptions& options,
                        const Context& context);

}  // namespace luxel
