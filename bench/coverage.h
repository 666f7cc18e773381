// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "luxel/trace/place_views.h"

#include "bench/accuracy.h"

namespace luxel::bench {

// Reference light for runs: the mean of independent runs. [side * bands + band], side 2 *
// patch, + 1 for its back.
struct KnownLight {
  std::vector<std::vector<float>> runs;  // W/m², each run's
  std::vector<float> irradiance;         // W/m², their mean
  std::vector<float> variance;           // of the mean, (W/m²)²; 0 of a single run, which is exact
  std::uint64_t rays = 0;                // of all runs
};

// Coverage of intervals of 95 %, and its standard error from the spread over seeds.
struct Held {
  double fraction = 0.0;
  double error = 0.0;
  std::size_t intervals = 0;
};

// All seeds of one scene at one requested error.
struct Coverage {
  double asked = 0.0;
  std::size_t seeds = 0;
  Held sides, sides_by_area;      // lit sides, band by band
  Held surfaces;                  // irradiance of the materials' sides, band by band
  Held power;                     // received, band by band
  double stated = 0.0;            // root mean square over seeds of the seen error
  double true_error = 0.0;        // the seen error by the mean square difference from the truth
  double power_bias = 0.0;        // mean of the received power over the truth's, less 1
  double power_bias_error = 0.0;  // its standard error, from the spread over seeds and the truth's
  double truth_part = 0.0;        // standard error of the truth over that of sides, root mean square by area
  double cpu_seconds = 0.0;       // of a seed
  double rays = 0.0;              // of a seed
};

// The mean of `runs` runs of other seeds without smoothing, `rays` rays in all. Kept in a file of
// settings.references.
KnownLight known_light(const Stage& stage, std::uint64_t rays, std::uint32_t runs, const Settings& settings,
                       const Context& context);

// Runs `seeds` seeds of the sampled solver from first_seed on, at its default options but for the error.
Coverage coverage_of(const Stage& stage, const Views& views, const KnownLight& truth, double error,
                     std::size_t seeds, std::uint64_t first_seed, const Context& context);

}  // namespace luxel::bench
