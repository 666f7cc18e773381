// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "luxel/cli/console.h"
#include "luxel/cli/run_report.h"
#include "luxel/cli/workplace.h"
#include "luxel/runs/outputs.h"
#include "luxel/runs/settings.h"

namespace luxel {

// Reports the end of a run: written files, accuracy (omitted where empty), time, rays and memory; with
// --verbose after a table of the stages.
void report_end(const RunRecord& record, const std::vector<std::string>& files, const std::string& accuracy,
                Console& console);

// Ends a command that wrote files: the lines above; the report as JSON; then --open.
void finish(const RunReport& report, const RunSettings& run, Console& console);

// Writes the outputs of a command that has a solution and finishes. Returns the exit code.
int write_and_finish(const Baked& baked, const Tracer* tracer, const OptionSet& options,
                     const OutputSettings& settings, const Workplace& place,
                     const StoredSamples& samples = {});

}  // namespace luxel
