// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace luxel {

// Neighbouring receivers whose samples of one kind are doubled together.
struct SampleUnit {
  double squared_error = 0.0;  // its part of the squared error
  double cost = 0.0;           // of its samples so far: so much again doubles them
};

// How often to double each unit's samples: whatever takes most off the error for its cost comes first, until
// the sum of squared_error is expected to be at most `target` and at least `least` is spent, or the next
// would be beyond `budget`. A doubling takes half of a unit's squared error off, or a little more.
std::vector<std::uint8_t> plan_doublings(std::span<const SampleUnit> units, double target, double least,
                                         double budget);

// The sum of squared_error that is left after those doublings, as plan_doublings() expects it.
double expected_squared_error(std::span<const SampleUnit> units, std::span<const std::uint8_t> doublings);

}  // namespace luxel
