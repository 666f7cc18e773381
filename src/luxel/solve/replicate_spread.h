// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/core/work_partition.h"

namespace luxel {

// Mean, standard error and squared error over replicates.
struct Spread {
  std::vector<float> mean;  // [receiver][band]
  // [receiver][band]: of the mean, from the spread and the bias; widened as Student's t is for so few
  // replicates, so that 1.96 of them hold the truth 95 times in 100.
  std::vector<float> standard_error;
  // [receiver][band]: of the mean, not widened: variance and bias, which is an estimate and may be below 0.
  // Sums over many receivers are honest; where every receiver counts as at least its variance, they are too
  // large.
  std::vector<float> squared_error;
  double total_squared_error =
      0.0;  // sum of area * variance of the mean, and of area * squared bias if that is above 0
  double total_squared_bias = 0.0;   // the second part of it
  double degrees_of_freedom = 0.0;   // of the variance
  double total_squared_light = 0.0;  // sum of area * mean²
};

// One set of replicates: [replicate][receiver * bands + band].
using Replicates = std::span<const std::vector<float>>;

// The receivers of each process, in the functions below and where their input is made.
inline LoopPartition spread_partition(const SharedWork& work, std::size_t receivers) {
  return {work, receivers, 4096};
}

struct SpreadInput {
  std::span<const float> bias;  // squared, [receiver * bands + band]; below 0 where an estimate is near 0
  std::size_t bands;
  std::span<const float> area;  // [receiver], m²
  std::size_t constraints = 1;  // degrees of freedom that are taken, at least one by the replicates' mean
};

// The same bits on any number of threads. Cost: about 50 ns per receiver for 8 replicates of 3 bands.
// Processes share the work; each needs the values of its part of spread_partition() at least.
Spread spread_of(Replicates values, const SpreadInput& input, const Context& context);
// Computes the same for first + second, replicate by replicate, in one pass.
Spread spread_of_sum(Replicates first, Replicates second, const SpreadInput& input, const Context& context);

// The variance of each receiver's mean, summed over bands: [receiver].
std::vector<double> squared_errors(Replicates values, std::size_t bands, const Context& context);

}  // namespace luxel
