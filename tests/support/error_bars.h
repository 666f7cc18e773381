// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "luxel/solution/solution.h"

#include "support/known_rooms.h"

namespace luxel::truth {

// A mean over independent runs, and the standard error of that mean from their spread. Patches of one run
// may lean on the same rays; runs do not, so this spread is honest whatever the patches do.
struct Measured {
  double value = 0.0;
  double standard_error = 0.0;
};

// How well solutions of one room, each of another seed, know their own errors. Lit: with more than nothing to
// receive, every side and band alike.
struct ErrorBarVerdict {
  // Share of lit numbers with |H - truth| <= 1.96 standard errors (and what the truth itself may be off).
  Measured coverage;
  // True error over predicted_error, both as root mean squares over runs; see true_error().
  Measured ratio;
  // Mean of A (H - truth) over mean of A truth: light too much or too little in the whole room.
  Measured bias;
  // Which share of the mean squared error is bias, patch by patch: the same in every run. From the products
  // of errors of runs in pairs, in which noise cancels; may come out below zero.
  Measured local_bias;
};
ErrorBarVerdict judge(const KnownRoom& room, std::span<const Solution> runs);

// Area-weighted relative RMS error of the irradiance of one run: sqrt(sum of A (H - truth)² / sum of
// A truth²) over sides and bands.
double true_error(const KnownRoom& room, const Solution& run);

// The same of the standard errors that the run states: sqrt(sum of A se² / sum of A H²).
double stated_error(const KnownRoom& room, const Solution& run);

}  // namespace luxel::truth
