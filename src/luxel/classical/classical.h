// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "luxel/classical/dense_operator.h"
#include "luxel/classical/hemicube_operator.h"
#include "luxel/classical/jacobi.h"
#include "luxel/classical/lines_operator.h"
#include "luxel/classical/solve_report.h"
#include "luxel/core/progress.h"
#include "luxel/core/workers.h"
#include "luxel/patch/patch_set.h"
#include "luxel/solution/solution.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// The classical methods: B = E + rho (D + F B) with E in B, so light from lamps reaches its receivers through
// F like any other; D, what the sky sends, comes through what F leaves free. They share no code for direct
// light with the sampled method, which they are there to prove, to measure and to explain.
//
// Each fills everything in `solution` but its command line and options, and is the same to the bit on any
// number of threads. The monitor hears of the stages "factors" and "light", and gets a picture
// (Progress::light) after every step of Jacobi, or at the end of another solver. Its stop ends the run with
// the last whole step; before the first, nothing but the lamps shines, and all power counts as unshot.
// Neither lamp nor sky is an InputError that says how to add one.

enum class DenseSolver { direct, jacobi, gauss_seidel };

struct DenseSolveOptions {
  DenseOptions factors = {};
  DenseSolver solver = DenseSolver::direct;
  JacobiOptions iteration = {};  // of jacobi; of gauss_seidel its tolerance
  std::vector<std::uint32_t> face =
      {};  // [patch]: patches of the same face share one value; empty: each its own
};

// All form factors, stored (Goral et al. 1984). standard_error of the solution is no noise: it is how far the
// light may be off by the errors of the integrated factors should they all lean the same way, and by a
// millionth for the rounding of floats. Memory: see DenseOperator and solve_directly(). Cost: quadratic, and
// cubic if solved directly.
SolveReport solve_dense(const PatchSet& patches, const Tracer& tracer, Solution& solution,
                        const DenseSolveOptions& options, const Workers& workers,
                        const Monitor& monitor = {});

struct HemicubeSolveOptions {
  HemicubeOptions hemicube = {};
  JacobiOptions iteration = {};
};

// A hemicube for each side in each step, nothing stored (Cohen and Greenberg 1985). No error is known, and
// none is stated. Cost: n hemicubes of n patches per step, and once before the first.
SolveReport solve_hemicube(const PatchSet& patches, Solution& solution, const HemicubeSolveOptions& options,
                           const Workers& workers, const Monitor& monitor = {});

struct LinesSolveOptions {
  LinesOptions lines = {};
  JacobiOptions iteration = {};
};

// Rows of local lines, stored, and Jacobi's iteration. Standard errors: see line_errors(); they do not hold
// the bias of the iteration, which unshot_fraction bounds, nor the small one of a product of two noisy rows.
// Cost: linear.
SolveReport solve_lines(const PatchSet& patches, const Tracer& tracer, Solution& solution,
                        const LinesSolveOptions& options, const Workers& workers,
                        const Monitor& monitor = {});

}  // namespace luxel
