// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "luxel/scene/scene.h"
#include "luxel/sky/sky_patches.h"

namespace luxel {

// Takes the lamps of a scene away and gives it this sky, cd/m², [sky patch].
void set_only_sky(const SkyPatches& patches, const std::vector<double>& luminance, Scene& scene);

}  // namespace luxel
