// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "luxel/solve/refine_to_light.h"

namespace luxel {

// The reason for the end of a refinement, as JSON spells it and for people.
struct RefineStopText {
  std::string_view name, description;
};
RefineStopText text_of(RefineStop stop);

// The mesh error after a refinement: "1.9 %", or "not yet known". 0: a mesh that leaves none, or no estimate.
std::string mesh_error_text(const RefineReport& report, double mesh_error);

// Describes the refinement of patches by the light. is_late: the time limit ended it.
std::string describe(const RefineReport& report, bool is_late);

}  // namespace luxel
