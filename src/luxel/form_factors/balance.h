// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/form_factors/exchange_areas.h"

namespace luxel {

struct Balance {
  std::vector<double> multiplier;  // [element], 1/m²: of the rows' sums
  double worst = 0.0;              // |row sum - area| / area that is left, the largest
  int steps = 0;                   // of Newton
  int passes = 0;                  // over all exchange areas
  bool is_stopped = false;         // by the monitor
};

// Finds the multipliers m for which x_ij = max(0, G_ij + variance_ij (m_i + m_j)), x_ii = max(0, G_ii +
// variance_ii m_i) and sinks of the same form fill every row: sum of x = area, m². Of all x >= 0 that do so,
// this one is nearest to G, measured in variances (the conditions of Karush, Kuhn and Tucker). Newton's
// method for functions that are smooth in pieces (Qi and Sun 1993); its sparse, positive equations by
// conjugate gradients with the diagonal as preconditioner. The variances' signs mark the x at 0 meanwhile, so
// that a pass reads 8 bytes per exchange area; some tens of passes. The same bits on any number of threads.
Balance balance_rows(ExchangeAreas& areas, std::span<const double> area, const Context& context = {});

// x of a listed exchange area in row i, and of a sink.
inline double balanced(const ExchangeAreas& areas, std::span<const double> multiplier, std::size_t i,
                       std::uint64_t at) {
  const auto j = areas.column[at];
  const auto sum = j == i ? multiplier[i] : multiplier[i] + multiplier[j];
  const auto x = areas.value[at] + std::fabs(static_cast<double>(areas.variance[at])) * sum;
  return x > 0.0 ? x : 0.0;
}
inline double balanced_sink(const ExchangeAreas::SinkColumn& sink, std::span<const double> multiplier,
                            std::size_t i) {
  const auto x = sink.value[i] + sink.variance[i] * multiplier[i];
  return x > 0.0 ? x : 0.0;
}

}  // namespace luxel
