// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "luxel/core/context.h"
#include "luxel/image/image.h"
#include "luxel/patch/patch_set.h"
#include "luxel/render/lightmap.h"

namespace luxel {

// Computes the radiance of the surfaces of a lightmap, W/(m² sr) by linear sRGB: the irradiance of each texel
// times the reflectance of its place, textures included, and its emission. Margins as in the lightmap. Throws
// MismatchError where the lightmap is of other patches or these have no colours. Returns no pages after the
// monitor's stop.
std::vector<Image> radiance_pages(const PatchSet& patches, const Lightmap& lightmap,
                                  const Context& context = {});

// Returns the 99.9th percentile of lit texels in any channel, so that the surroundings of a lamp do not
// darken all else. 1 where there is no light.
float white_of(const std::vector<Image>& pages);

// The irradiance of each page.
std::vector<Image> irradiance_pages(const Lightmap& lightmap);

}  // namespace luxel
