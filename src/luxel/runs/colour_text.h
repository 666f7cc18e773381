// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "luxel/patch/patch_set.h"

namespace luxel {

// A colour as the user types it: one number for all bands, red,green,blue (linear), or #rrggbb (sRGB, as a
// colour picker has it), each from 0 to `most`. [band]: where there are wavebands it is the spectrum that has
// the colour in white light. Throws UsageError whose text begins with `what`.
std::vector<float> colour_of_bands(const std::string& what, const std::string& text, const PatchSet& patches,
                                   float most);

}  // namespace luxel
