// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "luxel/core/workers.h"
#include "luxel/image/image.h"
#include "luxel/patch/patch_set.h"
#include "luxel/render/lightmap.h"

namespace luxel {

// What the surfaces of a lightmap send out, W/(m² sr) by linear sRGB: the irradiance of each texel on the
// colour of its place, textures too, and what it emits. Margins as in the lightmap. Throws MismatchError
// where the lightmap is of other patches or these have no colours. After the monitor's stop there are none.
std::vector<Image> radiance_pages(const PatchSet& patches, const Lightmap& lightmap, const Workers& workers,
                                  const Monitor& monitor = {});

// What 999 of 1000 texels with light do not exceed in any channel: a lamp's own neighbourhood shall not
// darken all else. 1 where there is no light.
float white_of(const std::vector<Image>& pages);

// The irradiance of each page.
std::vector<Image> irradiance_pages(const Lightmap& lightmap);

}  // namespace luxel
