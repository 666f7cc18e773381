// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "luxel/parallel/workers.h"

namespace luxel {

// What replicates say together.
struct Spread {
  std::vector<float> mean;  // [slot][band]
  // [slot][band]: of the mean, from the spread and the bias; widened as Student's t is for so few replicates,
  // so that 1.96 of them hold the truth 95 times in 100.
  std::vector<float> standard_error;
  std::vector<double> error2_of;  // [slot]: area * (variance of the mean + squared bias), all bands
  double error2 = 0.0;            // their sum
  double light2 = 0.0;            // sum of area * mean²
  double percentile_95 = 0.0;     // over lit slots: standard error over mean, root mean square over bands
};

// values: [replicate][slot * bands + band]; bias: squared, [slot * bands + band], may be below 0 where it is
// an estimate near 0. The same bits on any number of threads.
Spread spread_of(std::span<const std::vector<float>> values, std::span<const float> bias, std::size_t bands,
                 const std::function<double(std::size_t slot)>& area, const Workers& workers);

}  // namespace luxel
