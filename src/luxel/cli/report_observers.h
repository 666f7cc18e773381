// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/cli/report_settings.h"
#include "luxel/cli/workplace.h"
#include "luxel/export/lighting_report.h"

namespace luxel {

// Adds the observers at the walls and those of the file, their glare, and the verdicts of the report's planes
// on it; nothing where there are no lamps. Returns false where the user stopped the work. Throws InputError
// where the file of observers has no directions.
bool add_observers(const ReportSettings& settings, const SolutionProbe& probe, const Workplace& place,
                   LightingReport& report);

}  // namespace luxel
