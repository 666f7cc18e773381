// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "luxel/classical/method_options.h"
#include "luxel/classical/solve_report.h"
#include "luxel/core/context.h"
#include "luxel/patch/patch_set.h"
#include "luxel/solution/solution.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// Incremental stochastic Jacobi iteration for B = E + rho F B (listing 2 of the founding course paper;
// Neumann 1995; Bekaert 1999, chapter 6). Each step shoots the unshot power with rays in proportion to it, N
// = unshot / emitted * rays, so that every ray of every step carries the same quantum; the power that arrives
// and is reflected is the next unshot power; until its share of the emitted power falls below the tolerance.
// The sky shoots in the first step, from a box around the scene (SkyBox); its power that arrives counts as
// emitted.
//
// Fills irradiance and radiosity of both sides of every patch, and everything else in `solution` but its
// command line and options. The same input and seed give the same bits on any number of threads. A stop from
// the monitor ends it within a fraction of a second with an unbiased estimate of the bounces begun so far;
// the rest is in unshot_fraction. Throws InputError where there is neither lamp nor sky; its text explains
// how to add one.
//
// Error: relative standard error of a side's irradiance sqrt(P_T / (N P_i)), with P_T the power shot over the
// run by N rays and P_i the power that arrives. Cost: one nearest hit per ray.
SolveReport solve_stochastic_jacobi(const PatchSet& patches, const Tracer& tracer, Solution& solution,
                                    const StochasticJacobiOptions& options, const Context& context = {},
                                    const LightSink& on_light = {});

// A glance: few rays, enough to see the whole scene by, in a blink.
StochasticJacobiOptions glance(const PatchSet& patches);

// Returns the number of rays that `rays = 0` means, except for those of the sky that meet nothing.
std::uint64_t automatic_rays(const PatchSet& patches, double rays_per_patch);

// Power the lamps emit, W, [band].
std::vector<double> emitted_power(const PatchSet& patches);

}  // namespace luxel
