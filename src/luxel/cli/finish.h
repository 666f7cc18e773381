// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/cli/console.h"
#include "luxel/cli/outputs.h"
#include "luxel/cli/run_report.h"
#include "luxel/cli/settings.h"

namespace luxel {

// The end of a command that wrote files: the table of stages for a person; the report as JSON or, without it,
// the written files, one a line, on the standard output.
void finish(const RunReport& report, const RunSettings& run, Console& console);

// All that is left to do for a command that has a solution and only writes it. Returns the exit code.
int write_and_finish(const Baked& baked, const Tracer* tracer, const OptionSet& options,
                     const OutputSettings& settings, const Workplace& place,
                     const StoredSamples& samples = {});

}  // namespace luxel
