// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "luxel/solution/solution.h"

namespace luxel {

// Returns whether light fell on the back of a patch; false where the solution has no light of backs.
bool back_is_lit(const Solution& solution, std::size_t patch);

}  // namespace luxel
