// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "luxel/solution/solution.h"

#include "support/known_rooms.h"

namespace luxel::truth {

// A mean over independent runs, and the standard error of that mean from their spread. Patches of one run may
// use the same rays; runs do not, so this spread is valid for any correlation of patches.
struct Measured {
  double value = 0.0;
  double standard_error = 0.0;
};

// Quality of the stated errors of solutions of one room with different seeds. Lit: every side and band that
// receives light.
struct ErrorBarVerdict {
  // Fraction of lit numbers with |H - truth| <= 1.96 standard errors (plus the error of the truth itself).
  Measured coverage;
  // True error over predicted_error, both as root mean squares over runs; see true_error().
  Measured ratio;
  // Mean of A (H - truth) over mean of A truth: relative excess of light in the whole room.
  Measured bias;
  // Fraction of the mean squared error that is bias, patch by patch: the error common to all runs. From
  // products of errors of pairs of runs, in which noise cancels; may be negative.
  Measured local_bias;
};
ErrorBarVerdict judge(const KnownRoom& room, std::span<const Solution> runs);

// Area-weighted relative RMS error of the irradiance of one run: sqrt(sum of A (H - truth)² / sum of
// A truth²) over sides and bands.
double true_error(const KnownRoom& room, const Solution& run);

// The same for the standard errors that the run states: sqrt(sum of A se² / sum of A H²).
double stated_error(const KnownRoom& room, const Solution& run);

}  // namespace luxel::truth
