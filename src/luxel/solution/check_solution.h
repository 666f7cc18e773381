// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "luxel/patch/patch_set.h"
#include "luxel/solution/solution.h"

namespace luxel {

// The first thing that is wrong, as a sentence without its end ("patch 7 has the area -1 m²"), or nothing
// where both keep the promises of their headers: the arrays are as long as they must be, every index is in
// range, every number finite, normals are unit, areas above zero, and the light is of these bands and this
// scene.
std::string fault_in(const PatchSet& patches, const Solution& solution);

}  // namespace luxel
