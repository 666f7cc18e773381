// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <string>

#include <gtest/gtest.h>

namespace luxel::test {

// A number and its standard error, widened as Student's t is.
struct WithError {
  double value = 0.0, error = 0.0;
};

// Compares a measurement, WithError measure(seed), with the truth: they may differ by three standard errors
// and the accuracy, which is absolute and belongs to rounding and to the table of an intensity distribution.
//
// Risk. Three standard errors from eight replicates are exceeded by chance 9 times in a thousand. A figure
// that is beyond is therefore measured once more with other random numbers, and fails if it is beyond again:
// 8 times in 100,000, together about three times in a hundred for all figures. A bias of six true standard
// errors is detected 93 times in 100, of seven 99 times.
template <typename Measure>
void expect_truth(Measure measure, double truth, double accuracy, const std::string& figure) {
  WithError measured;
  for (const std::uint64_t seed : {1, 2}) {
    measured = measure(seed);
    if (std::abs(measured.value - truth) <= 3.0 * measured.error + accuracy) return;
  }
  ADD_FAILURE() << figure << ": measured " << measured.value << " with a standard error of " << measured.error
                << ", expected " << truth << ", twice beyond three standard errors";
}

}  // namespace luxel::test
