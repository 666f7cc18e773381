// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/patch/patch_set.h"

namespace luxel {

// Throws the InputError that says how to add light where there is neither lamp nor sky.
void check_light(const PatchSet& patches);

}  // namespace luxel
