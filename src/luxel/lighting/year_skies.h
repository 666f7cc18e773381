// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/photometry/sky_patches.h"
#include "luxel/photometry/weather.h"

namespace luxel {

// Sky and sun of one record of a weather file, by Perez's model.
struct DaylightHour {
  std::size_t record = 0;  // of Weather::hours
  double time = 0.0;       // h of local standard time at the middle of the record
  double duration = 1.0;   // h
  SunPosition sun;
  double sky_illuminance = 0.0;  // of the ground by the sky, lx
  double sun_illuminance = 0.0;  // of a plane that faces the sun, lx; 0 where it is below the horizon
};

// The skies of all hours with light, in the order of the weather file.
struct YearSkies {
  SkyPatches patches;
  std::vector<DaylightHour> hours;
  std::vector<float> luminance;  // cd/m², [hour * sky patches + sky patch], without the sun's disc

  std::span<const float> of(std::size_t hour) const {
    return std::span(luminance).subspan(hour * patches.size(), patches.size());
  }
};

// albedo: of the ground. Cost: 4 us per hour and patch, divided among the threads of the context.
YearSkies skies_of_year(const Weather& weather, const SkyPatches& patches, double albedo,
                        const Context& context = {});

// A sky for which rays are traced, cd/m², [sky patch], that stands for all hours: their mean, each with the
// sun spread over the patch that it stands in.
std::vector<double> mean_sky(const YearSkies& skies);

}  // namespace luxel
