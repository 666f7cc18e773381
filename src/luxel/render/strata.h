// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>

#include "luxel/core/address.h"
#include "luxel/core/vector.h"

namespace luxel {

// Numbers for side² samples that belong together: one in each cell of a square grid (jittered sampling,
// Cook 1986), and pairs of different names in independent orders. A single sample is uniform over all its
// pairs.
class Strata {
 public:
  // name: keeps pairs apart; side: 1 to 1024.
  Strata(std::uint64_t key, std::uint32_t name, std::uint32_t side) : side_(side), count_(side * side) {
    const auto bits = nth_key(key, 2 * std::uint64_t{name});
    first_ = static_cast<std::uint32_t>(bits) % count_;
    step_ = 1 + static_cast<std::uint32_t>(bits >> 32) % count_;
    while (std::gcd(step_, count_) != 1) ++step_;
  }

  // Returns the point of sample i, below side²; jitter: uniform in [0, 1).
  Vec2 pair(std::uint32_t i, float u1, float u2) const {
    const auto cell = cell_of(i);
    return {within(cell % side_, u1, side_), within(cell / side_, u2, side_)};
  }
  float number(std::uint32_t i, float u) const { return within(cell_of(i), u, count_); }

 private:
  std::uint32_t cell_of(std::uint32_t i) const {
    return static_cast<std::uint32_t>((first_ + std::uint64_t{i} * step_) % count_);
  }
  static float within(std::uint32_t cell, float u, std::uint32_t cells) {
    constexpr float below_one = 0x1.fffffep-1f;
    return std::min(below_one, (static_cast<float>(cell) + u) / static_cast<float>(cells));
  }

  std::uint32_t side_, count_, first_, step_;
};

}  // namespace luxel
