// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>

#include "luxel/classical/solve_report.h"
#include "luxel/core/context.h"
#include "luxel/patch/patch_set.h"
#include "luxel/solution/solution.h"
#include "luxel/trace/tracer.h"

namespace luxel {

struct SampleState;

/// Measure of SampledOptions::error, by which rays are also distributed.
enum class ErrorMeasure {
  seen,  ///< 95 % of the views, spread over the open space, stay below it (trace/seen_error.h)
  power  ///< area-weighted relative RMS of the irradiance: bright surfaces own it
};

struct SampledOptions {
  /// The solve ends at the first of these bounds.
  double error = 0.02;  ///< standard error, by error_measure; 0: no bound
  ErrorMeasure error_measure = ErrorMeasure::seen;
  std::uint64_t rays = 0;  ///< traced; 0: no bound
  /// The run ends at the answer whose rays are nearest to this number, on a logarithmic scale, even if the
  /// error is not reached. Rounds stay as large as without a bound: a longer run passes through this answer.
  std::uint64_t ray_budget = 0;  ///< 0: no bound
  /// The run goes on to half of `error` where about this number of rays suffices for it; 0: never.
  std::uint64_t cheap_rays = 0;
  double seconds = 0.0;  ///< wall clock; 0: no bound
  /// Maximum memory, bytes. Hits that do not fit are traced again instead of stored: slower, the same result.
  std::uint64_t memory = 0;      ///< 0: half of what is free when the solve begins
  std::uint64_t seed = 1;        ///< another seed gives an independent solution
  std::uint32_t replicates = 8;  ///< independent solutions whose spread is the error bar, 4 to 32

  /// Variance reduction. Each can be switched separately; docs/performance.md has the gains.
  bool low_discrepancy = true;  ///< Owen-scrambled Sobol points, else independent random numbers
  bool stratified = true;       ///< one sequence runs over neighbouring patches, else each has its own
  bool importance = true;       ///< lamps are chosen by what they can contribute, else by area
  bool control_variate = true;  ///< the closed form of unshadowed direct light carries the shadow rays
  /// Beside each shadow ray a cosine ray of its own, which counts where it meets a lamp (balance heuristic);
  /// in place of the control variate.
  bool multiple_importance = false;
  /// Light is smoothed over neighbouring patches whose own rays have not reached the error, from 4,096 sides
  /// on; the bias of smoothing is part of the error bar.
  bool smoothing = true;

  bool both_ways = true;  ///< rays count at both ends, otherwise only at the side that sends them
};

/// Start of a solve, and its intermediate results.
struct SolveHooks {
  /// State to continue from: of the same patches, light groups and options except the bounds. None: a new
  /// run.
  std::shared_ptr<const SampleState> from = {};
  /// Called with the state after every doubling, from which a run can continue. Its hits are shared with the
  /// run, the rest is a copy. Empty: none is made.
  std::function<void(std::shared_ptr<const SampleState>)> keep = {};
  /// Called with every intermediate picture of the light; the monitor is called next, with the same progress.
  LightSink on_light = {};
  /// Receives, with every answer, the light of each half of the replicates: two estimates that are
  /// independent but for the light that one half's noise reflects to the other, whose mean is the solution.
  /// Their errors are those of the halves, without bias. Null: none.
  std::array<Solution, 2>* halves = nullptr;
};

/// The production solver: direct light D from Owen-scrambled points on patch and lamp; transport F as a
/// sampled operator, 2^k cosine rays per patch side whose first hits are stored; the reflected light R = rho
/// (D + F R) solved to 1e-6, B = E + R; every number with a standard error from independent replicates;
/// samples are doubled, all earlier ones remain in use, until the requested error is reached. The equations
/// are in docs/theory.md.
///
/// The run ends when error_measure is below `error`; for the seen error, with the jackknife's standard error
/// added. Views come from PatchSet::cameras, focuses_on_cameras and focus. Without any view (no
/// open space is found) the power-weighted error takes the place of the seen one.
///
/// A side's standard error is widened like Student's t for few replicates, so that 1.96 of it contain the
/// true value on these patches in 95 of 100 cases; predicted_error, of the whole, is not. Neither contains
/// the error from the size of patches. Sides that no light reaches, by the first rays, stay dark.
///
/// Fills everything in `solution` but its command line and options. The same input, options and seed give the
/// same bits on any number of threads, stored or streamed, as long as time does not end it. hooks.on_light
/// gets a first picture of the whole scene after a fraction of a second, and one after every doubling; the
/// monitor's stop ends the run with the last of them. Progress::done is the fraction of the solve's time that
/// has passed, 0 until an answer allows an estimate; it never decreases, and time inside the monitor does not
/// count. Throws InputError if there is no light, MismatchError if the state is not of these patches and
/// options. A run that was stopped and continued gives the same bits as one that was not.
///
///
/// Processes (Context::ranks()) divide the work: each calls the solver with the same arguments except memory
/// and monitor, and all get the same bits as one process alone. The monitor of the first may stop all of
/// them.
SolveReport solve_sampled(const PatchSet& patches, const Tracer& tracer, Solution& solution,
                          const SampledOptions& options, const SolveHooks& hooks, const Context& context);

/// Solves from the beginning, without intermediate pictures.
inline SolveReport solve_sampled(const PatchSet& patches, const Tracer& tracer, Solution& solution,
                                 const SampledOptions& options, const Context& context = {}) {
  return solve_sampled(patches, tracer, solution, options, SolveHooks{}, context);
}

}  // namespace luxel
