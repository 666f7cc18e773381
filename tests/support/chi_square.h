// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace luxel::statistics {

// Pearson's statistic of counts against one expected count for all cells.
inline double chi_square(const std::vector<std::size_t>& counts, double expected) {
  double sum = 0.0;
  for (const auto c : counts)
    sum += (static_cast<double>(c) - expected) * (static_cast<double>(c) - expected) / expected;
  return sum;
}

// The value that chi-square with k degrees of freedom exceeds with a probability of one in a
// million: Wilson and Hilferty 1931, good to a per cent for k > 10. Every statistical test here runs at that
// risk of a false alarm.
inline double chi_square_limit(double k) {
  constexpr double z = 4.7534;  // one-sided normal quantile of 1e-6
  const double a = 2.0 / (9.0 * k);
  return k * std::pow(1.0 - a + z * std::sqrt(a), 3.0);
}
// The value that chi-square falls below with the same probability.
inline double chi_square_lower_limit(double k) {
  constexpr double z = 4.7534;
  const double a = 2.0 / (9.0 * k);
  return k * std::pow(std::max(0.0, 1.0 - a - z * std::sqrt(a)), 3.0);
}

}  // namespace luxel::statistics
