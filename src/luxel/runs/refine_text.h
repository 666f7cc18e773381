// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "luxel/solve/refine_to_light.h"

namespace luxel {

// Why a refinement ended, as JSON spells it and for people.
struct RefineStopText {
  std::string_view name, description;
};
RefineStopText text_of(RefineStop stop);

// How patches were put where the light needs them. is_late: the time limit ended it.
std::string describe(const RefineReport& report, bool is_late);

}  // namespace luxel
