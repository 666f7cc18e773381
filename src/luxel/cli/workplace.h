// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/cli/console.h"
#include "luxel/runs/run_place.h"

namespace luxel {

// References to the things that the steps of a command share.
struct Workplace {
  const Context& context;
  Console& console;
  RunRecord& record;
  const TimeBudget* budget = nullptr;  // null: no limit

  // NOLINTNEXTLINE(google-explicit-constructor): it is one
  operator RunPlace() const { return {context, console, record, budget}; }
};

}  // namespace luxel
