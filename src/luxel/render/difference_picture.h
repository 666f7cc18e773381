// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "luxel/image/image.h"
#include "luxel/patch/patch_set.h"
#include "luxel/scene/camera.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// Signed shares as colours: white is no difference, red is more in B, blue is less, full at +-scale; darker
// reds and blues lie beyond. Where there is nothing to compare (NaN): grey. Below the picture stands the
// scale with its numbers. Display-referred, linear RGB in [0, 1].
//
// shares: [pixel], width * height, row by row. scale: above 0; automatic_scale() makes one.
Image difference_picture(std::span<const float> fractions, int width, int height, float scale);

// Returns the 95th percentile of the shares, rounded up to 1, 2 or 5 times a power of ten; 0.01 where there
// are none.
float automatic_scale(std::span<const float> fractions);

// The shares of patch sides ([side], see relative_differences()) as a camera sees them, one ray through the
// middle of each pixel: what is seen, side by side; NaN where nothing is.
std::vector<float> seen_fractions(const PatchSet& patches, std::span<const float> of_side,
                                  const Tracer& tracer, const Camera& camera, int width, int height);

}  // namespace luxel
