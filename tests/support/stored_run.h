// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <utility>

#include "luxel/solve/sampled.h"

namespace luxel::truth {

// A solve and its samples.
struct StoredRun {
  Solution solution;
  std::shared_ptr<const SampleState> state;
};

inline StoredRun stored_run(const PatchSet& patches, const Tracer& tracer, const SampledOptions& options,
                            const Context& context) {
  StoredRun run;
  const SolveHooks storing{
      .from = {}, .keep = [&](auto state) { run.state = std::move(state); }, .on_light = {}};
  solve_sampled(patches, tracer, run.solution, options, storing, context);
  return run;
}

}  // namespace luxel::truth
