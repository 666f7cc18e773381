// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <vector>

namespace luxel {

// Returns the value that this fraction of the values, in [0, 1], does not exceed: the one of rank
// floor(fraction (n - 1)), from 0. values: at least one, none of them NaN. Cost: linear.
template <typename Number>
Number percentile(std::vector<Number> values, double fraction) {
  assert(!values.empty() && fraction >= 0.0 && fraction <= 1.0);
  const auto at =
      values.begin() + static_cast<std::ptrdiff_t>(fraction * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace luxel
