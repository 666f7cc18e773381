// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "luxel/patch/patch_set.h"

namespace luxel {

enum class StopReason { converged, stopped_by_user, nothing_to_do };

// Where a solution came from: enough to make it again.
struct Provenance {
  std::string program_version;
  std::string command_line;  // that makes it again; empty from a library call
  std::string method;        // "stochastic-jacobi"
  std::vector<std::pair<std::string, std::string>>
      options;  // every option with its value, in declaration order
  std::uint64_t seed = 0;
  std::uint64_t rays = 0;  // traced
  std::uint64_t scene_fingerprint = 0;
};

// The light: irradiance and radiosity of both sides of every patch. Arrays are [patch][band], flat. A
// one-sided material's back holds zeros. radiosity = emittance (front only) + reflectance * irradiance.
struct Solution {
  std::vector<std::string> bands;
  std::vector<float> irradiance_front, irradiance_back;  // W/m²
  std::vector<float> radiosity_front, radiosity_back;    // W/m²
  double unshot_share = 0.0;     // power not yet propagated over the emitted power: the stated bias
  double predicted_error = 0.0;  // area-weighted relative RMS standard error of the irradiance, from theory
  StopReason stop = StopReason::nothing_to_do;
  Provenance provenance;
};

}  // namespace luxel
