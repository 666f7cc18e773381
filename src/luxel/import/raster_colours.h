// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/image/raster.h"

namespace luxel {

// The mean linear colour of all pixels, whatever their alpha. Finite, 0 or more.
Vec3 mean_colour(const Raster& raster);

float mean_alpha(const Raster& raster);
// The lowest alpha of all pixels.
float min_alpha(const Raster& raster);

// A white picture that is there where the other one is bright: its alpha is the other's grey, as its codes
// have it (no light, a plain number).
Raster with_grey_as_alpha(const Raster& raster);

// Metalness of surfaces from a picture: its blue channel, a linear number and no colour, in [0, 1].
struct MetalRange {
  float least = 0.0f, mean = 0.0f, most = 0.0f;
};
MetalRange metal_range(const Raster& raster);

// The colours of `base` (white where there is none), lowered to `most` where they are of metal, in proportion
// to factor * metal, which covers the same surface and may be of another size.
Raster with_lowered_metal(const Raster* base, const Raster& metal, float factor, float most);

}  // namespace luxel
