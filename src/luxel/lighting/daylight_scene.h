// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "luxel/photometry/sky_patches.h"
#include "luxel/scene/scene.h"

namespace luxel {

// The traditional overcast sky of the CIE, type 16, cd/m², [sky patch]: for daylight factors alone. albedo:
// of the ground.
std::vector<double> overcast_sky(const SkyPatches& patches, double albedo);

// Takes the lamps of a scene away and gives it this sky, cd/m², [sky patch].
void set_only_sky(const SkyPatches& patches, const std::vector<double>& luminance, Scene& scene);

}  // namespace luxel
