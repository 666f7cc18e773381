// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>

namespace luxel {

// Power as 64-bit integers. Integer sums do not depend on their order, so any number of threads gets the same
// bits, and shot power equals received, escaped and absorbed power to the last unit.
struct FixedPoint {
  double unit = 1.0;  // W, a power of two: conversions only move the exponent

  // The finest unit in which `max_sum` watts, spread over every counter or heaped on one, cannot
  // overflow: at most 2^61 units.
  static FixedPoint for_sum(double max_sum) {
    return {max_sum > 0.0 ? std::exp2(std::ilogb(max_sum) - 60) : 1.0};
  }
  std::int64_t units(double watts) const { return std::llround(watts / unit); }
  double watts(std::int64_t units) const { return static_cast<double>(units) * unit; }
};

}  // namespace luxel
