// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/patch/patch_set.h"
#include "luxel/session/session_settings.h"
#include "luxel/solution/solution.h"

namespace luxel {

// The patches with other lamps and colours, to be solved anew: what Relighter makes of the same numbers, to
// the bit, and the same fingerprint. Throws InputError where there are not as many as Lighting asks for, or
// one is out of its range.
PatchSet relit_patches(PatchSet patches, const Lighting& lighting);

// Adds to the provenance what differs from the scene's own lamps and colours, as options of `luxel relight`.
void describe_lighting(const PatchSet& patches, const Lighting& lighting, Provenance& provenance);

}  // namespace luxel
