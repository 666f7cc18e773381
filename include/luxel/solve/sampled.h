// SPDX-License-Identifier: Apache-2.0
#pragma once

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

/// What SampledOptions::error is, and what deals the rays.
enum class ErrorMeasure {
  seen,  ///< 95 % of the views, spread over the open space, stay below it (trace/seen_error.h)
  power  ///< area-weighted relative RMS of the irradiance: bright surfaces own it
};

struct SampledOptions {
  /// When to stop: at the first of these.
  double error = 0.02;  ///< standard error, by error_measure; 0: never for that
  ErrorMeasure error_measure = ErrorMeasure::seen;
  std::uint64_t rays = 0;  ///< traced; 0: no bound
  double seconds = 0.0;    ///< wall clock; 0: no bound
  /// Bytes the solver may hold. What does not fit is traced again instead of stored: slower, the same bytes.
  std::uint64_t memory = 0;      ///< 0: half of what is free when the solve begins
  std::uint64_t seed = 1;        ///< another seed, another independent answer
  std::uint32_t replicates = 8;  ///< independent answers whose spread is the error bar, 4 to 32

  /// What makes the same rays worth more. Each can be switched alone; docs/performance.md says what it gains.
  bool low_discrepancy = true;  ///< Owen-scrambled Sobol points, else independent random numbers
  bool stratified = true;       ///< one sequence runs over neighbouring patches, else each has its own
  bool importance = true;       ///< lamps are chosen by what they can contribute, else by area
  bool control_variate = true;  ///< the closed form of unshadowed direct light carries the shadow rays
  /// Beside each shadow ray a cosine ray of its own, which counts where it meets a lamp (balance heuristic);
  /// in place of the control variate.
  bool multiple_importance = false;
  /// Neighbouring patches share their rays where their own have not reached the error, from 4,096 sides on;
  /// what that may get wrong is part of the error bar.
  bool smoothing = true;

  bool both_ways = true;  ///< rays count at both their ends, else at that of the side which sends them
};

/// What a solve starts from and what it hands out on the way.
struct SolveHooks {
  /// Where to go on: a state of the same patches, options but for the bounds, and light groups. None: afresh.
  std::shared_ptr<const SampleState> from = {};
  /// Called with every answer, the solution filled: what a run needs to go on from it. Its hits are shared
  /// with the run, the rest is a copy. Empty: none is made.
  std::function<void(std::shared_ptr<const SampleState>)> keep = {};
  /// Called with every intermediate picture of the light; the monitor is called next, with the same progress.
  LightSink on_light = {};
};

/// The production solver: direct light D from Owen-scrambled points on patch and lamp; transport F as a
/// sampled operator, 2^k cosine rays per patch side whose first hits are stored; the reflected light R = rho
/// (D + F R) solved to 1e-6, B = E + R; every number with a standard error from independent replicates;
/// samples doubled, all earlier ones kept, until the error asked for is reached. The equations are in
/// docs/theory.md.
///
/// The run ends when error_measure is below `error`; of the seen error, when it is so by the jackknife's
/// standard error too. Views come from PatchSet::cameras, focuses_on_cameras and focus. Without any view (no
/// open space is found) the power-weighted error takes the place of the seen one.
///
/// A side's standard error is widened as Student's t is for so few replicates, so that 1.96 of it hold the
/// truth on these patches 95 times in 100; predicted_error, of the whole, is not. What the size of patches
/// does is in neither. Sides that no light reaches, as far as the first rays can tell, are left dark.
///
/// Fills everything in `solution` but its command line and options. The same input, options and seed give the
/// same bits on any number of threads, stored or streamed, as long as time does not end it. hooks.on_light
/// gets a first picture of the whole scene after a fraction of a second, and one after every doubling; the
/// monitor's stop ends the run with the last of them. Progress::done is the fraction of the solve's time that
/// has passed, 0 until an answer allows a forecast; it never falls, and time inside the monitor does not
/// count. No lamp at all is an InputError that says how to add one; a state that is not of these patches and
/// options a MismatchError. A run that was stopped and taken up again gives the same bits as one that was
/// not.
///
/// Processes (Context::ranks()) share the work: each calls the solver with the same arguments but for memory
/// and monitor, and all get the same answer, to the bit that of one alone. The first one's monitor may stop
/// them all.
SolveReport solve_sampled(const PatchSet& patches, const Tracer& tracer, Solution& solution,
                          const SampledOptions& options, const SolveHooks& hooks, const Context& context);

/// The same from nothing, without intermediate pictures.
inline SolveReport solve_sampled(const PatchSet& patches, const Tracer& tracer, Solution& solution,
                                 const SampledOptions& options, const Context& context = {}) {
  return solve_sampled(patches, tracer, solution, options, SolveHooks{}, context);
}

}  // namespace luxel
