// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "luxel/core/vector.h"
#include "luxel/patch/side.h"
#include "luxel/surface/smooth_light.h"

namespace luxel {

// The smooth irradiance of one band at a point of a side, W/m². weights: barycentric, of the corners 1 and 2.
// Number: of the sum; pictures of many pixels add floats.
template <typename Number = double>
Number smooth_irradiance(const SmoothLight& light, SideId side, const Vec2& weights, std::size_t band,
                         std::size_t bands) {
  const auto& values = light.irradiance.of(side);
  const auto& corners = light.corners[side.patch()];
  const float weight[] = {1.0f - weights.x - weights.y, weights.x, weights.y};
  Number sum = 0;
  for (std::size_t k = 0; k < 3; ++k)
    sum += static_cast<Number>(weight[k]) * static_cast<Number>(values[corners[k] * bands + band]);
  return sum;
}

// Light that leaves a side at a point without its emission, W/m²: the reflected light and, for a diffuser,
// the light transmitted from the other side.
inline double smooth_sent_on(const PatchSet& patches, const SmoothLight& light, SideId side,
                             const Vec2& weights, std::size_t band) {
  const auto bands = patches.band_count();
  const auto reflected = static_cast<double>(patches.reflectance(side.patch(), band)) *
                         smooth_irradiance(light, side, weights, band, bands);
  if (!patches.material_of(side.patch()).is_diffuser()) return reflected;
  return reflected + static_cast<double>(patches.diffuse_transmittance(side.patch(), band)) *
                         smooth_irradiance(light, side.opposite(), weights, band, bands);
}

}  // namespace luxel
