// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "luxel/classical/gauss_seidel.h"
#include "luxel/core/context.h"
#include "luxel/solve/sampled_operator.h"

namespace luxel {

// The mean of some replicates, number by number; at least one of them. The same bits on any number of
// threads.
std::vector<float> mean_of(std::span<const std::vector<float>> replicates, const Context& context);

// Radiosities of CrossedHalves in which the sky shines and nothing else yet: W/m², [row or sink][band].
std::vector<float> dark_but_for_sky(const HitStore& hits, const PatchSet& patches);

// The light that reaches each receiver from other surfaces, replicate by replicate.
struct ReplicateLight {
  bool is_stopped = false;                   // by the monitor; the rest counts for nothing then
  std::vector<std::vector<float>> gathered;  // [replicate], W/m², [receiver * bands + band]
  GaussSeidelReport iteration;
};

// Solves B = S (D + F B), S the scattering rho or, with diffusers, rho and tau, for both halves of the
// replicates, each scattering the light that the other gathered, to `tolerance`; the light is the mean of the
// two. Each replicate differs from it by its influence u on that mean: the difference of its own rays and
// direct light, propagated as long as that changes its errors,
//
//     u_r = (h_r - mean of h) + (D_r - mean of D) + F S u_r,     F of the other half.
//
// So the mean over replicates is the solution with all rays, and their spread its error.
//
// direct: [replicate][receiver * bands + band], W/m²; scattering: [receiver * bands + band]; radiosity:
// reflected, W/m², [row or sink of CrossedHalves][band], the start and the result; that of the sinks stays,
// so the sky is one. The same bits on any number of threads. Cost: two look-ups per ray for each sweep; the
// influences cost as much as some sweeps more.
ReplicateLight solve_replicates(const SampledOperator& transport, std::span<const std::vector<float>> direct,
                                const Scattering& scattering, std::span<float> radiosity, double tolerance,
                                const Context& context = {});

}  // namespace luxel
