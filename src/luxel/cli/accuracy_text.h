// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "luxel/classical/solve_report.h"
#include "luxel/cli/run_report.h"

namespace luxel {

// The accuracy of the light of a run as a plain sentence; empty where the command solved no light.
std::string accuracy_text(const RunReport& report);

// The accuracy of a merged or relit solution.
std::string accuracy_text(const Solution& solution);

// The reason why a run ended before it was accurate enough, and its consequence. target: the requested error,
// a fraction; nothing: the method has no target.
std::string stopped_text(const SolveReport& solved, const std::optional<double>& target);

}  // namespace luxel
