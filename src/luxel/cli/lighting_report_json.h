// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "luxel/cli/daylight_report.h"
#include "luxel/export/lighting_report.h"

namespace luxel {

// The numbers of a report as JSON; docs/json.md lists its keys. daylight: null without its sections. outputs:
// files that were written.
std::string json_of(const LightingReport& report, const DaylightReport* daylight,
                    const std::vector<std::string>& outputs);

}  // namespace luxel
