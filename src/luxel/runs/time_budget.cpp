// SPDX-License-Identifier: Apache-2.0
#include "luxel/runs/time_budget.h"

#include <utility>

namespace luxel {

Monitor TimeBudget::stopping(Monitor monitor, const bool& can_stop) const {
  return [this, monitor = std::move(monitor), &can_stop](const Progress& progress) {
    const auto next = tell(monitor, progress);
    return can_stop && is_over() ? Next::stop : next;
  };
}

}  // namespace luxel
