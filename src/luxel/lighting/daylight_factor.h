// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "luxel/lighting/coefficients.h"
#include "luxel/lighting/grid_figures.h"

namespace luxel {

// Daylight factors, fractions: illuminance over that of open ground under an overcast sky of the CIE without
// sun.
struct DaylightFactors {
  int cie_type = 16;
  double albedo = 0.2;                                        // of the ground
  std::vector<std::vector<float>> replicates;                 // [replicate][point]
  std::array<std::vector<float>, daylight_paths> components;  // [path][point], means over replicates
  std::vector<float> value, standard_error;                   // [point]; errors not widened
  Figure mean, median, min, min_over_mean;                    // over the points
};

// cie_type: 16, 1 or another that does not follow the sun. Throws InputError for one that does.
DaylightFactors daylight_factors(const DaylightCoefficients& coefficients, int cie_type, double albedo);

// The fraction of points where numbers reach a limit.
double fraction_reached(std::span<const float> values, double limit);
double median_of(std::span<const float> values);

// EN 17037, by daylight factors: the target factor on half of the points, the minimum one on 95 %. diffuse:
// the median diffuse illuminance of the hours of daylight, lx.
struct FactorProvision {
  const char* level = "";  // "minimum", "medium", "high"
  double target_factor = 0.0, minimum_factor = 0.0;
  Figure on_target, on_minimum;  // fractions of the points that reach them
  enum class Verdict { met, not_met, cannot_tell } verdict = Verdict::cannot_tell;
};
std::vector<FactorProvision> factor_provision(const DaylightFactors& factors, double diffuse);

}  // namespace luxel
