// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/slow_process.h"

#include <algorithm>
#include <vector>

namespace luxel {

std::optional<SlowProcess> slow_process(std::span<const double> waits, double seconds) {
  if (waits.size() < 2) return {};
  std::vector<double> sorted(waits.begin(), waits.end());
  std::sort(sorted.begin(), sorted.end());
  const auto longer = sorted[1] - sorted[0];
  if (!(longer >= std::max(1.0, 0.05 * seconds))) return {};
  const auto slow = std::find(waits.begin(), waits.end(), sorted[0]) - waits.begin();
  return SlowProcess{static_cast<std::size_t>(slow), longer};
}

}  // namespace luxel
