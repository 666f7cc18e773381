// SPDX-License-Identifier: Apache-2.0
#include "luxel/daylight/daylight_scene.h"

#include <algorithm>

#include "luxel/scene/luminous_efficacy.h"
#include "luxel/sky/sky_integrals.h"

namespace luxel {

std::vector<double> mean_sky_of_year(const Weather& weather, const SkyPatches& patches, double albedo) {
  std::vector<double> sum(patches.size(), 0.0);
  double hours = 0.0;
  for (std::size_t h = 0; h < weather.hours.size(); ++h) {
    const auto sun = sun_of(weather, h);
    const auto sky = perez_sky(weather, h, sun);
    if (!(sky.diffuse_illuminance > 0.0)) continue;
    const auto direct = sun.direction.z > 0.0 ? sky.direct_normal_illuminance : 0.0;
    const auto luminance =
        sky_patch_luminances(sky.model, patches,
                             {.horizontal_illuminance = sky.diffuse_illuminance,
                              .direct_horizontal_illuminance = direct * std::max(0.0, sun.direction.z),
                              .ground_albedo = albedo});
    for (std::size_t p = 0; p < sum.size(); ++p) sum[p] += luminance[p];
    if (direct > 0.0) {
      const auto patch = patches.patch_of(patches.in_scene_axes(sun.direction));
      sum[patch] += direct / patches.solid_angle(patch);
    }
    hours += 1.0;
  }
  for (auto& s : sum) s /= std::max(1.0, hours);
  return sum;
}

void set_only_sky(const SkyPatches& patches, const std::vector<double>& luminance, Scene& scene) {
  for (auto& material : scene.materials) {
    material.emittance = Vec3(0.0f);
    material.emittance_spectrum = {};
    material.textures.emittance.reset();
  }
  scene.point_lights.clear();
  scene.sky = Vec3(0.0f);
  scene.sky_spectrum = {};
  scene.sky_patches = patches;
  scene.sky_radiance.clear();
  for (const auto l : luminance) scene.sky_radiance.emplace_back(static_cast<float>(l / luminous_efficacy));
}

}  // namespace luxel
