// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "luxel/core/workers.h"
#include "luxel/patch/patch_set.h"
#include "luxel/solution/sample_state.h"
#include "luxel/solution/solution.h"
#include "luxel/solve/sampled.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// The light of a sampled run bounce by bounce, from the samples it kept and without a ray more: Jacobi's
// iteration over all replicates together,
//
//     H_0 = 0,    H_k = D + F (rho H_(k-1)),    B_k = E + rho H_k.
//
// After no bounce there are the lamps alone, after one their direct light; after many it is the run's own
// answer, but where neighbours shared their rays there, and without its errors. Not for several threads at
// once.
class Bounces {
 public:
  // Keeps references to patches, tracer and workers. options: of the run. Throws MismatchError where the
  // state is not of these patches.
  Bounces(const PatchSet& patches, const Tracer& tracer, const SampleState& state,
          const SampledOptions& options, const Workers& workers);
  ~Bounces();
  Bounces(const Bounces&) = delete;
  Bounces& operator=(const Bounces&) = delete;

  // The light after so many bounces, at least 0. Cost: a look-up a ray for each bounce more than it was asked
  // for last; for fewer it begins anew. unshot_fraction: what the last bounce brought and none has sent on,
  // over the power of the lamps; under a sky, which has no power of its own, 0.
  Solution light(int bounces);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace luxel
