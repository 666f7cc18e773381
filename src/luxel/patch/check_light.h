// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/patch/patch_set.h"

namespace luxel {

// Throws InputError where the scene has neither lamp nor sky; its text explains how to add light.
void check_light(const PatchSet& patches);

// Throws InputError where the sky is not the same all over: for methods that use only the fraction of it that
// a side sees. Its text names other methods.
void check_even_sky(const PatchSet& patches);

// Throws InputError where panes of glass absorb light: for methods that support surfaces only. Its text names
// other methods.
void check_no_panes(const PatchSet& patches);

}  // namespace luxel
