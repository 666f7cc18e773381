// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/core/context.h"
#include "luxel/runs/reporter.h"
#include "luxel/runs/run_record.h"
#include "luxel/runs/time_budget.h"

namespace luxel {

// References to the things that the stages of a run share.
struct RunPlace {
  const Context& context;
  Reporter& reporter;
  RunRecord& record;
  const TimeBudget* budget = nullptr;  // null: no limit
};

}  // namespace luxel
