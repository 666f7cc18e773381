// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/patch/patch_set.h"
#include "luxel/viewer/lines.h"

namespace luxel {

// Adds the photometric solid of each luminaire of the patches as a wire frame about its photometric centre:
// its radius in a direction is proportional to the luminous intensity, and the largest is half a metre or a
// tenth of the scene's size (m), whichever is less. In the colour that the luminaire has there.
void add_photometric_solids(const PatchSet& patches, float scene_size, Marks& marks);

}  // namespace luxel
