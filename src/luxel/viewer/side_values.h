// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "luxel/session/session_snapshot.h"
#include "luxel/viewer/look.h"

namespace luxel {

// Returns the values that surfaces show as one number per patch side: [2 * patch + 1 for the back]. NaN where
// there is none. light: may be null where the number is of the mesh alone. difference: from a second
// solution, or null. Empty where no values are available. Cost: linear.
std::vector<float> side_values(Show show, bool lux, const PatchSet& patches, const SessionLight* light,
                               const LightDifference* difference);

// Returns whether the numbers change with the light.
bool is_of_light(Show show);
// Unit and heading of the legend: "lux", "W/m²", "m", "%", ...
const char* unit_of(Show show, bool lux);
const char* heading_of(Show show);

}  // namespace luxel
