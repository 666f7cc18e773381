// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/patch/patch_set.h"
#include "luxel/session/session_settings.h"
#include "luxel/solution/solution.h"

namespace luxel {

// Returns the patches with other lamps and colours, for another solve: bitwise equal to those of
// Relighter, with the same fingerprint. Throws InputError where the number of values is not that of
// Lighting, or one is out of range.
PatchSet relit_patches(PatchSet patches, const Lighting& lighting);

// Adds differences from the scene's own lamps and colours to the provenance, as options of `luxel relight`.
void describe_lighting(const PatchSet& patches, const Lighting& lighting, Provenance& provenance);

}  // namespace luxel
