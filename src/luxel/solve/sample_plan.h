// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace luxel {

// Neighbouring slots whose samples of one kind are doubled together.
struct SampleUnit {
  double error2 = 0.0;  // its part of the squared error
  double cost = 0.0;    // of its samples so far: so much again doubles them
};

// How often to double each unit's samples: whatever takes most off the error for its cost comes first, until
// the sum of error2 is expected to be at most `target` or `budget` is spent. A doubling takes half of a
// unit's squared error off, or a little more. None at all where even the first is beyond the budget.
std::vector<std::uint8_t> plan_doublings(std::span<const SampleUnit> units, double target, double budget);

// The same, but with `least` spent at least, if that is not beyond the budget.
std::vector<std::uint8_t> plan_round(std::span<const SampleUnit> units, double target, double least,
                                     double budget);

}  // namespace luxel
