// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/patch/patch_set.h"

namespace luxel {

// Throws InputError where the scene has neither lamp nor sky; its text explains how to add light.
void check_light(const PatchSet& patches);

// Throws InputError where the sky is not the same all over: for methods that know only how much of it a side
// sees. Its text names those that can.
void check_even_sky(const PatchSet& patches);

// Throws InputError where panes of glass absorb light: for methods that know surfaces alone. Its text names
// those that can.
void check_no_panes(const PatchSet& patches);

}  // namespace luxel
