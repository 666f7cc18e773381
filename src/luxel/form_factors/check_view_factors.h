// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "luxel/core/context.h"
#include "luxel/form_factors/view_factors.h"

namespace luxel {

// Checks three laws of view factors on the known rows: rows sum to 1 (with environment, backs and dropped),
// A_i F_ij = A_j F_ji, 0 <= F_ij <= 1.
struct FactorCheck {
  std::uint64_t rows = 0;      // that were looked at
  bool is_whole = true;        // not stopped before all known ones were
  std::uint64_t count = 0;     // listed factors in all
  double worst_row_sum = 0.0;  // the largest |sum - 1|
  std::uint32_t worst_row = 0;
  double smallest = 0.0, largest = 0.0;  // listed factors
  // Root mean square over pairs of |A_i F_ij - A_j F_ji| / max(A_i, A_j), so the difference as a factor from
  // the larger element; its value expected from the standard errors; and the largest. 0 where no pair has
  // both rows known.
  double reciprocity = 0.0, expected_reciprocity = 0.0, worst_reciprocity = 0.0;
  std::array<std::uint32_t, 2> worst_pair = {0, 0};  // where that is
  // Fractions of the power leaving all rows, by area.
  double environment = 0.0, backs = 0.0, dropped = 0.0;
};

// The same bits on any number of threads. Cost: each listed factor is read a few times. Memory: 16 bytes per
// factor of one in 128 rows, for each thread. Where the monitor stops the work, the result covers the rows so
// far.
FactorCheck check_view_factors(const ViewFactors& factors, const Context& context = {});

}  // namespace luxel
