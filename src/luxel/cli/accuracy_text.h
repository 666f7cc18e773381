// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "luxel/classical/solve_report.h"
#include "luxel/cli/run_report.h"

namespace luxel {

// How accurate the light of a run is, in a sentence without jargon; empty where the command solved none.
std::string accuracy_text(const RunReport& report);

// The same of a merged or relit solution.
std::string accuracy_text(const Solution& solution);

// Why a run ended before it was as accurate as it should be, and what that leaves open. target: the requested
// error, a fraction; nothing: none can be requested.
std::string stopped_text(const SolveReport& solved, const std::optional<double>& target);

}  // namespace luxel
