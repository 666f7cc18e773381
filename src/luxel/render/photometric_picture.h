// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "luxel/image/image.h"
#include "luxel/patch/patch_set.h"

namespace luxel {

// The same patches as ideal white surfaces without emission and without a sky: a picture of their light
// (render()) has a radiance of irradiance over pi.
PatchSet white_patches(const PatchSet& patches);

// Values of the pixels of a picture of radiance, row by row: luminance, cd/m²; and of a picture of
// white_patches(), illuminance of the seen surfaces, lx.
std::vector<double> luminance_values(const Image& radiance);
std::vector<double> illuminance_values(const Image& radiance);

}  // namespace luxel
