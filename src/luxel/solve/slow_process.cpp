// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/slow_process.h"

#include <algorithm>
#include <iterator>
#include <vector>

namespace luxel {

std::optional<SlowProcess> slow_process(std::span<const double> waits, double seconds) {
  if (waits.size() < 2) return {};
  const auto least = std::min_element(waits.begin(), waits.end());
  std::vector<double> others(waits.begin(), least);
  others.insert(others.end(), std::next(least), waits.end());
  const auto longer = *std::min_element(others.begin(), others.end()) - *least;
  if (!(longer >= std::max(1.0, 0.05 * seconds))) return {};
  return SlowProcess{static_cast<std::size_t>(std::distance(waits.begin(), least)), longer};
}

}  // namespace luxel
