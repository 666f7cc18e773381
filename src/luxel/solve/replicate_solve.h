// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "luxel/parallel/workers.h"
#include "luxel/solve/gauss_seidel.h"
#include "luxel/transport/sampled_operator.h"

namespace luxel {

// The mean of some replicates, number by number; at least one of them. The same bits on any number of
// threads.
std::vector<float> mean_of(std::span<const std::vector<float>> replicates, const Workers& workers);

// The start of an iteration in which the sky shines and nothing else yet: W/m², [element * bands + band].
std::vector<float> dark_but_for_sky(const SampledOperator& transport, const PatchSet& patches);

// The light that reaches each slot from other surfaces, replicate by replicate.
struct ReplicateLight {
  bool is_stopped = false;                   // by the monitor; the rest counts for nothing then
  std::vector<std::vector<float>> gathered;  // [replicate], W/m², [slot * bands + band]
  GaussSeidelReport iteration;
};

// Solves B = rho (D + F B) with the mean of all replicates, to `tolerance`, and puts each replicate around
// it: its own direct light goes through its own rays for two bounces more, by which its noise has gone as far
// as it can be told from the rest. So the mean over replicates is the solution with all rays, and their
// spread its error.
//
// direct: [replicate][slot * bands + band], W/m²; reflectance: [slot * bands + band]; radiosity: reflected,
// W/m², [element * bands + band], the start and the result; that of the sinks stays, so the sky is one. The
// same bits on any number of threads. Cost: one look-up a ray for each sweep and for each own bounce.
ReplicateLight solve_replicates(const SampledOperator& transport, std::span<const std::vector<float>> direct,
                                std::span<const float> reflectance, std::span<float> radiosity,
                                double tolerance, const Workers& workers, const Monitor& monitor = {});

}  // namespace luxel
