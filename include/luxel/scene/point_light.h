// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "luxel/core/vector.h"

namespace luxel {

enum class PointLightKind : std::uint8_t { point, spot, directional };

/// A lamp without a surface, as glTF has them (KHR_lights_punctual).
struct PointLight {
  std::string name;
  PointLightKind kind = PointLightKind::point;
  Vec3 position = Vec3(0.0f);  ///< m, counted from the scene's origin; of no use to directional ones
  Vec3 direction = Vec3(0.0f, -1.0f, 0.0f);  ///< unit, the way its light goes; of no use to points
  /// Linear sRGB, by the luminous efficacy of the house: radiant intensity, W/sr, of points and spots (along
  /// the axis); irradiance of what faces it, W/m², of directional ones.
  Vec3 intensity = Vec3(1.0f);
  /// Of a spot: cosines of the angles from its axis where it begins to fade and where it has ended; between
  /// them its intensity is times ((cos - cos_outer) / (cos_inner - cos_outer))², as glTF has it.
  float cos_inner = 1.0f, cos_outer = 0.70710678f;
};

}  // namespace luxel
