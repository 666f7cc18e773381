// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "luxel/core/progress.h"
#include "luxel/patch/patch_set.h"
#include "luxel/patch/side.h"
#include "luxel/solution/stop_reason.h"

namespace luxel {

/// Random numbers that a solution was computed with.
struct RandomStream {
  std::uint64_t seed = 0;
  std::uint64_t rays = 0;  ///< traced with them

  bool operator==(const RandomStream&) const = default;
};

/// Origin of a solution: all that is needed to reproduce it.
struct Provenance {
  std::string program_version;
  std::string command_line;  ///< that makes it again; empty from a library call
  std::string method;        ///< "sampled", "stochastic-jacobi", "dense", "hemicube", "lines"
  /// every option with its value, in declaration order
  std::vector<std::pair<std::string, std::string>> options;
  std::uint64_t seed = 0;
  std::uint64_t rays = 0;  ///< traced
  std::uint64_t scene_fingerprint = 0;
  std::vector<RandomStream> merged;  ///< by seed; empty: a single run, with the seed and rays above
};

/// The light: irradiance and radiosity of both sides of every patch. Arrays are [patch][band], flat. A
/// one-sided material's back holds zeros. radiosity = emittance (front only) + reflectance * irradiance.
struct Solution {
  std::vector<std::string> bands;
  SideValues irradiance;  ///< W/m²
  SideValues radiosity;   ///< W/m²
  /// Standard error of the irradiance of each side, from the spread of independent replicates and the
  /// estimated bias of smoothing; widened like Student's t for few replicates, so that 1.96 of them contain
  /// the true value in 95 of 100 cases. Dense: maximum deviation due to the errors of the form factors. Empty
  /// where the method gives none.
  SideValues standard_error;  ///< W/m²
  /// The part of that which is bias of smoothing, not widened: it stays when independent answers are merged.
  /// Empty where nothing was smoothed.
  SideValues smoothing_bias;     ///< W/m²
  double unshot_fraction = 0.0;  ///< power not yet propagated over the emitted power: the stated bias
  double predicted_error = 0.0;  ///< area-weighted relative RMS standard error of the irradiance, not widened
  /// The error that can be seen: 95 % of the views, spread over the open space of the scene, stay below it
  /// (see trace/seen_error.h); not widened. 0: not estimated.
  double seen_error = 0.0;
  double predicted_bias = 0.0;  ///< the part of predicted_error that is bias of smoothing
  /// degrees of freedom of the standard errors; 0: not from replicates
  double error_degrees_of_freedom = 0.0;
  /// Like seen_error, but due to the size of the patches in the reconstructed light; 0: not estimated.
  double mesh_error = 0.0;
  double error_95th = 0.0;  ///< see solution/error_95th.h; 0: not estimated
  StopReason stop = StopReason::nothing_to_do;
  Provenance provenance;
};

/// Receives intermediate pictures of a solve: the light so far, which is valid during the call, and how far
/// the solve has come. Called from the calling thread.
using LightSink = std::function<void(const Solution&, const Progress&)>;

}  // namespace luxel
