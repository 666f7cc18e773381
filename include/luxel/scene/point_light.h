// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "luxel/core/vector.h"
#include "luxel/photometry/photometry.h"

namespace luxel {

enum class PointLightKind : std::uint8_t { point, spot, directional, luminaire };

/// A lamp without a surface: a punctual light as glTF has them (KHR_lights_punctual), or a luminaire with the
/// luminous intensity distribution and the opening of a photometric file.
struct PointLight {
  std::string name;
  PointLightKind kind = PointLightKind::point;
  Vec3 position = Vec3(0.0f);  ///< m, counted from the scene's origin; of no use to directional ones
  Vec3 direction = Vec3(0.0f, -1.0f, 0.0f);  ///< unit, the way its light goes; of no use to points
  /// Linear sRGB, by Luxel's luminous efficacy: radiant intensity, W/sr, of points and spots (along the
  /// axis); for directional lights the irradiance of a surface that faces them, W/m²; for luminaires the
  /// radiant intensity where the distribution is largest, dimming, maintenance and colour included; the
  /// colour's relative luminance is 1, so that colour never changes lumens.
  Vec3 intensity = Vec3(1.0f);
  /// Spots: cosines of the angles from the axis where the intensity begins to fade and where it reaches 0; in
  /// between it is multiplied by ((cos - cos_outer) / (cos_inner - cos_outer))², as in glTF.
  float cos_inner = 1.0f, cos_outer = 0.70710678f;
  /// rad, [0, 0.5], of a directional one: its light comes evenly from a disc of this angular radius around
  /// -direction. 0: from one direction; its shadows are hard.
  float angular_radius = 0.0f;

  // The following are of a luminaire.
  std::shared_ptr<const Photometry> photometry = nullptr;  ///< shared by all luminaires of one file
  /// Unit and orthogonal: its local X and Y in the scene; local -Z is `direction`.
  Vec3 local_x = Vec3(1.0f, 0.0f, 0.0f), local_y = Vec3(0.0f, 0.0f, -1.0f);
  float dimming = 1.0f;      ///< part of its flux that it is set to, above 0
  float maintenance = 1.0f;  ///< maintenance factor, (0, 1]: part of its initial flux that counts
};

}  // namespace luxel
