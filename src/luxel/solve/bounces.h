// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "luxel/core/context.h"
#include "luxel/patch/patch_set.h"
#include "luxel/solution/sample_state.h"
#include "luxel/solution/solution.h"
#include "luxel/solve/sampled.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// Computes the light of a sampled run bounce by bounce, from its stored samples without tracing rays:
// Jacobi's iteration over all replicates together,
//
//     H_0 = 0,    H_k = D + F (rho H_(k-1)),    B_k = E + rho H_k.
//
// After no bounce there are the lamps alone, after one their direct light; after many it is the run's own
// answer, except for its smoothing over neighbours, and without its errors. Not for several threads at
// once.
class Bounces {
 public:
  // Keeps references to patches, tracer and context. options: of the run. Throws MismatchError where the
  // state is not of these patches.
  Bounces(const PatchSet& patches, const Tracer& tracer, const SampleState& state,
          const SampledOptions& options, const Context& context);
  ~Bounces();
  Bounces(const Bounces&) = delete;
  Bounces& operator=(const Bounces&) = delete;

  // Returns the light after this many bounces, at least 0. Cost: a look-up per ray for each bounce beyond the
  // last call's; fewer bounces start again from 0. unshot_fraction: power that the last bounce brought and
  // that is not reflected yet, over the power of the lamps; 0 under a sky, which has no power of its own.
  Solution light(int bounces);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace luxel
