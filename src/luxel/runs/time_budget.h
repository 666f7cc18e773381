// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/core/context.h"
#include "luxel/runs/run_record.h"

namespace luxel {

// The time of --time: of the whole process, from its start to its last file.
class TimeBudget {
 public:
  // seconds: from the start of the process; 0: no limit. Keeps the reference.
  TimeBudget(double seconds, const RunRecord& record) : seconds_(seconds), record_(record) {}

  bool is_limited() const { return seconds_ > 0.0; }
  double seconds() const { return seconds_; }
  double left() const { return seconds_ - record_.elapsed(); }

  // Reserves time for what comes after the stages that heed the budget, s.
  void reserve(double seconds) { reserved_ = seconds; }
  double reserved() const { return reserved_; }
  bool is_over() const { return is_limited() && left() < reserved_; }
  // Stops a stage when its time is over, as soon as `can_stop` is true.
  Monitor stopping(Monitor monitor, const bool& can_stop) const;

 private:
  double seconds_;
  double reserved_ = 0.0;
  const RunRecord& record_;
};

}  // namespace luxel
