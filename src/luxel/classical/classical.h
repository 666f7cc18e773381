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

// The classical methods: B = E + rho (D + F B) with E in B, so that direct light from lamps is transported by
// F as well; D, the light of the sky, arrives through the remainder of each row of F. They share no code for
// direct light with the sampled method, which they serve to verify, to measure and to explain.
//
// Each fills everything in `solution` but its command line and options, and is the same to the bit on any
// number of threads. The monitor receives the stages "factors" and "light", and on_light a picture
// after every step of Jacobi, or at the end of another solver. A stop by the monitor ends the run with the
// last whole step; before the first, only the lamps emit, and all power counts as unshot. Throws InputError
// where there is neither lamp nor sky; its text explains how to add one.

// All form factors, stored (Goral et al. 1984). standard_error of the solution is not noise: it is the
// error of the light if the errors of all integrated factors have the same sign, plus a millionth for the
// rounding of floats. Memory: see DenseOperator and solve_directly(). Cost: quadratic, and cubic if solved
// directly.
SolveReport solve_dense(const PatchSet& patches, const Tracer& tracer, Solution& solution,
                        const DenseSolveOptions& options, const Context& context = {},
                        const LightSink& on_light = {});

// A hemicube for each side in each step, nothing stored (Cohen and Greenberg 1985). The error is unknown, and
// none is stated. Cost: n hemicubes of n patches per step, and once before the first.
SolveReport solve_hemicube(const PatchSet& patches, Solution& solution, const HemicubeSolveOptions& options,
                           const Context& context = {}, const LightSink& on_light = {});

// Rows of local lines, stored, and Jacobi's iteration. Standard errors: see line_errors(); they do not hold
// the bias of the iteration, which unshot_fraction bounds, nor the small one of a product of two noisy rows.
// Cost: linear.
SolveReport solve_lines(const PatchSet& patches, const Tracer& tracer, Solution& solution,
                        const LinesSolveOptions& options, const Context& context = {},
                        const LightSink& on_light = {});

}  // namespace luxel
