// SPDX-License-Identifier: Apache-2.0
#include "luxel/lighting/daylight_scene.h"

#include "luxel/photometry/sky_integrals.h"
#include "luxel/scene/luminous_efficacy.h"

namespace luxel {

std::vector<double> overcast_sky(const SkyPatches& patches, double albedo) {
  return sky_patch_luminances(SkyModel::cie(16), patches, 10'000.0, albedo);
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
