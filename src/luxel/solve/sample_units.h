// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "luxel/solve/sample_plan.h"
#include "luxel/solve/sampling.h"

namespace luxel {

// Processor time of a shadow ray over that of a gather ray with its part of all sweeps. Measured: 0.66 in the
// Cornell box, 0.6 in a furnished hall, 0.78 in the reading room, 0.5 in a living room lit through windows.
constexpr double shadow_ray_cost = 0.6;

// What the shadow rays of each unit (first) and the gather rays of each receiver (then) cost, and their parts
// of the squared error: importance times that of the receivers' direct light, and gathered_squared_error,
// scaled so that all together are `whole`. All [receiver].
std::vector<SampleUnit> make_sample_units(const Sampling& sampling, std::uint32_t replicates,
                                          std::span<const double> importance,
                                          std::span<const double> direct_squared_error,
                                          std::span<const double> gathered_squared_error, double whole);

// Cost of all samples so far, that of make_sample_units() but for rounding.
double cost_of_samples(const Sampling& sampling, std::uint32_t replicates);

// What a variance of 1 of each receiver's own light, before smoothing, does to the error: importance times
// the part of the variance that smoothing leaves, in the mean over each unit. All [receiver]; begins: of
// units.
std::vector<double> importance_of_own_noise(std::span<const std::uint32_t> begins,
                                            std::span<const double> importance,
                                            std::span<const double> own_squared_error,
                                            std::span<const double> smoothed_squared_error);

// Sum of the products.
double weighted_sum(std::span<const double> weights, std::span<const double> values);

}  // namespace luxel
