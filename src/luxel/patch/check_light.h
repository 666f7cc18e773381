// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/patch/patch_set.h"

namespace luxel {

// Throws InputError where the scene has neither lamp nor sky; its text explains how to add light.
void check_light(const PatchSet& patches);

}  // namespace luxel
