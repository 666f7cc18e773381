// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "luxel/classical/stochastic_jacobi.h"
#include "luxel/scene/scene.h"
#include "luxel/solve/sampled.h"

#include "bench/sections.h"

namespace luxel::bench {

// A scene ready to be solved.
struct Stage {
  std::string name;
  PatchSet patches;
  Tracer tracer;

  // Triangles as they come.
  Stage(std::string the_name, const Scene& scene, const Context& context);
};

// Converged irradiance, the reference for runs.
struct Reference {
  std::vector<float> front, back;  // W/m², [patch][band]
  double error = 0.0;              // its own standard error, area-weighted relative RMS, as predicted
  std::uint64_t rays = 0;
  bool from_file = false;
};

// By the sampled solver without sharing (which has no bias), with a seed that no run uses, until `error` or
// for `seconds`; by shooting where that comes nearer in the same time. Kept in a file of settings.references
// named by the scene's fingerprint, so that the next run finds it.
Reference reference_of(const Stage& stage, double error, double seconds, const Settings& settings,
                       const Context& context);

// One solve, or the mean of a few with different seeds where it is short.
struct Run {
  std::string setting;
  double cpu_seconds = 0.0;  // of the whole call, all threads
  double wall_seconds = 0.0;
  std::uint64_t rays = 0;
  double predicted_error = 0.0;
  // sqrt(sum A (H - H*)² / sum A H*²) over both sides and all bands.
  double difference = 0.0;
  // The same after subtraction of the reference's squared error; nothing where that is more than four fifths
  // of it, since the difference would be too uncertain.
  std::optional<double> true_error;
  double bias = 0.0;        // area-weighted mean of (H - H*) / H* where H* is above a hundredth of its mean
  double power_bias = 0.0;  // sum A (H - H*) / sum A H*
  StopReason stop = StopReason::nothing_to_do;
};

using Solver = std::function<SolveReport(Solution& solution, std::uint64_t seed)>;
Run run(const Stage& stage, const Reference& reference, std::string setting, const Solver& solver);

// Runs a method with finer and finer settings. Sampled: requested errors, ending early with the first that
// takes `seconds`. Shooting: rays per patch.
std::vector<Run> sampled_runs(const Stage& stage, const Reference& reference, SampledOptions options,
                              const std::vector<double>& errors, double seconds, const Context& context);
std::vector<Run> shooting_runs(const Stage& stage, const Reference& reference,
                               const std::vector<double>& rays_per_patch, const Context& context);

// Cost of a true error of `target`: between two runs by interpolation of the logarithms; beyond the last one
// by 1/sqrt(time) ("extrapolated"); at most that of the first run where it is better already ("at most");
// nothing ("unknown") where the reference is too coarse to determine the error of any run.
struct Price {
  double cpu_seconds = 0.0;
  double rays = 0.0;
  std::string how;
};
Price price_of(const std::vector<Run>& runs, double target);
// The same cost by the solver's own estimate of the error.
Price predicted_price_of(const std::vector<Run>& runs, double target);

Json to_json(const Run& run);
Json to_json(const Price& price);

}  // namespace luxel::bench
