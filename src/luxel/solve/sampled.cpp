// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/sampled.h"

#include "luxel/solve/stochastic_jacobi.h"

namespace luxel {

// Stands in until the sampled operator is here.
SolveReport solve_sampled(const PatchSet& patches, const Tracer& tracer, Solution& solution,
                          const SampledOptions& options, const Workers& workers, const Monitor& monitor) {
  return solve_stochastic_jacobi(patches, tracer, solution, {.seed = options.seed}, workers, monitor);
}

}  // namespace luxel
