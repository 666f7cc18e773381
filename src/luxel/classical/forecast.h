// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "luxel/classical/classical.h"
#include "luxel/core/workers.h"
#include "luxel/patch/patch_set.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// What a solve is likely to take.
struct Forecast {
  std::uint64_t sides = 0;  // that gather light
  double seconds = 0.0;
  std::uint64_t bytes = 0;  // at the peak, beside patches and tracer
};

// Judged from a few form factors, hemicubes or lines that are made and timed, half a second or a little more,
// and from how fast light decays at the mean reflectance. Good to a factor of two or three: meant to tell
// minutes from days. Depends on the machine and its load.
Forecast forecast_dense(const PatchSet& patches, const Tracer& tracer, const DenseSolveOptions& options,
                        const Workers& workers);
Forecast forecast_hemicube(const PatchSet& patches, const HemicubeSolveOptions& options,
                           const Workers& workers);
Forecast forecast_lines(const PatchSet& patches, const Tracer& tracer, const LinesSolveOptions& options,
                        const Workers& workers);

}  // namespace luxel
