// SPDX-License-Identifier: Apache-2.0
#include "luxel/lighting/year_skies.h"

#include <algorithm>

#include "luxel/photometry/sky_integrals.h"

namespace luxel {
namespace {

constexpr std::size_t hours_per_chunk = 16;

}  // namespace

YearSkies skies_of_year(const Weather& weather, const SkyPatches& patches, double albedo,
                        const Context& context) {
  YearSkies skies{patches, {}, {}};
  std::vector<SkyModel> models;
  for (std::size_t h = 0; h < weather.hours.size(); ++h) {
    const auto& record = weather.hours[h];
    DaylightHour hour{h, record.end - 0.5 * record.duration, record.duration, sun_of(weather, h), 0.0, 0.0};
    const auto perez = perez_sky(weather, h, hour.sun);
    hour.sky_illuminance = perez.diffuse_illuminance;
    if (hour.sun.direction.z > 0.0) hour.sun_illuminance = perez.direct_normal_illuminance;
    if (!(hour.sky_illuminance > 0.0)) continue;
    skies.hours.push_back(hour);
    models.push_back(perez.model);
  }
  const auto width = patches.size();
  skies.luminance.resize(skies.hours.size() * width);
  context.for_chunks(skies.hours.size(), hours_per_chunk, [&](std::size_t begin, std::size_t end, int) {
    for (auto h = begin; h < end; ++h) {
      const auto& hour = skies.hours[h];
      const auto luminance = sky_patch_luminances(
          models[h], patches,
          {.horizontal_illuminance = hour.sky_illuminance,
           .direct_horizontal_illuminance = hour.sun_illuminance * std::max(0.0, hour.sun.direction.z),
           .ground_albedo = albedo});
      std::transform(luminance.begin(), luminance.end(),
                     skies.luminance.begin() + static_cast<std::ptrdiff_t>(h * width),
                     [](double l) { return static_cast<float>(l); });
    }
  });
  return skies;
}

std::vector<double> mean_sky(const YearSkies& skies) {
  const auto& patches = skies.patches;
  std::vector<double> sum(patches.size(), 0.0);
  for (std::size_t h = 0; h < skies.hours.size(); ++h) {
    const auto luminance = skies.of(h);
    for (std::size_t p = 0; p < sum.size(); ++p) sum[p] += static_cast<double>(luminance[p]);
    const auto& hour = skies.hours[h];
    if (!(hour.sun_illuminance > 0.0)) continue;
    const auto patch = patches.patch_of(patches.in_scene_axes(hour.sun.direction));
    sum[patch] += hour.sun_illuminance / patches.solid_angle(patch);
  }
  for (auto& s : sum) s /= static_cast<double>(std::max<std::size_t>(1, skies.hours.size()));
  return sum;
}

}  // namespace luxel
