// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "luxel/scene/scene.h"
#include "luxel/sky/sky_patches.h"
#include "luxel/sky/weather.h"

namespace luxel {

// A sky for which rays are traced, cd/m², [sky patch], that stands for all hours: the mean over those with
// light of Perez's skies, the sun spread over the patch that it stands in, and the ground. albedo: of the
// ground. Cost: 1 µs per hour and patch.
std::vector<double> mean_sky_of_year(const Weather& weather, const SkyPatches& patches, double albedo);

// Takes the lamps of a scene away and gives it this sky, cd/m², [sky patch].
void set_only_sky(const SkyPatches& patches, const std::vector<double>& luminance, Scene& scene);

}  // namespace luxel
