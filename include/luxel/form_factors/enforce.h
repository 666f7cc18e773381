// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "luxel/core/context.h"
#include "luxel/form_factors/view_factors.h"

namespace luxel {

/// Report of enforce_laws().
struct Enforcement {
  /// Root mean square and largest change of a listed factor, and the root mean square of the second step's
  /// change in standard errors of the exchange areas: near 1 or below where these are honest.
  double rms_change = 0.0, max_change = 0.0, change_in_standard_errors = 0.0;
  double worst_row_sum_before = 0.0;  ///< |sum - 1| after both directions were joined
  double worst_row_sum = 0.0;         ///< after all
  int steps = 0;                      ///< of Newton
  int passes = 0;                     ///< over all exchange areas
  std::uint64_t count = 0;  ///< listed factors afterwards: a pair seen from one side alone is listed twice
  bool is_stopped = false;  ///< by the monitor, before all laws held
};

/// Enforces the laws of view factors: all known rows sum to 1, A_i F_ij = A_j F_ji, none below 0.
///
/// 1. The two estimates of each exchange area, A_i F_ij and A_j F_ji, are joined with weights rays / area:
/// the inverse of the variances of counts. Weights from the measured spread would favour factors that were
/// counted low by chance.
/// 2. Exchange areas x >= 0, environment and other sinks too, are sought that make all row sums exact and
/// change least: sum (x - G)² / variance is smallest. The variance is the mean of the estimate from
/// replicates and that of counts, scaled to the same total, since a few replicates estimate a spread poorly.
/// Pairs that were never counted stay 0.
///
/// Weighted least squares after van Leersum 1989, Lawson 1995, Taylor and Luck 1995, and Clarksean and
/// Solbrig 1994; here with bounds, solved for the rows' multipliers by Newton's method and conjugate
/// gradients. Standard errors become those of step 1. Every row must be known, else InputError. The same bits
/// on any number of threads. Memory: 20 bytes per factor listed afterwards, which then hold the factors.
/// Cost: some tens of passes over the factors. If the monitor stops during step 1, factors remain as they
/// were; later, reciprocity and bounds hold and rows sum to 1 except for worst_row_sum.
Enforcement enforce_laws(ViewFactors& factors, const Context& context = {});

}  // namespace luxel
