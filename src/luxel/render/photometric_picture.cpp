// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/photometric_picture.h"

#include <algorithm>
#include <numbers>

#include "luxel/scene/luminous_efficacy.h"

namespace luxel {

PatchSet white_patches(const PatchSet& patches) {
  auto white = patches;
  for (auto& material : white.materials) {
    std::fill(material.reflectance.begin(), material.reflectance.end(), 1.0f);
    std::fill(material.emittance.begin(), material.emittance.end(), 0.0f);
    material.textures = {};
  }
  white.sky.clear();
  white.panes.clear();  // illuminance is that of the surface, whatever lies before it
  white.textures.clear();
  white.uv_sets.clear();
  white.corner_colours.clear();
  white.reflectance_ratio.clear();
  white.emittance_ratio.clear();
  return white;
}

std::vector<double> luminance_values(const Image& radiance) {
  std::vector<double> values;
  values.reserve(radiance.pixels.size());
  for (const auto& p : radiance.pixels)
    values.push_back(lumens(static_cast<double>(p.r), static_cast<double>(p.g), static_cast<double>(p.b)));
  return values;
}

std::vector<double> illuminance_values(const Image& radiance) {
  auto values = luminance_values(radiance);
  for (auto& v : values) v *= std::numbers::pi;
  return values;
}

}  // namespace luxel
