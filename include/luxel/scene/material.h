// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "luxel/core/vector.h"
#include "luxel/scene/spectrum.h"
#include "luxel/scene/texture.h"

namespace luxel {

enum class MaterialId : std::uint32_t {};

/// A diffuse surface, linear sRGB.
struct Material {
  std::string name = {};
  Vec3 reflectance = Vec3(0.5f);  ///< [0, 1); load caps it, see LoadOptions::max_reflectance
  Vec3 emittance = Vec3(0.0f);    ///< W/m² a band, of the front side only; pi times the radiance (OBJ's Ke)
  bool two_sided = true;          ///< false: the back absorbs what meets it and is counted

  bool opaque = true;  ///< false: light passes as if it were not there (a pane of glass)

  /// In the place of the colours above, which stay the means over the pictures, for who asks for the material
  /// as a whole: what is textured has a mean above 0 in each band in which its texture is anywhere.
  MaterialTextures textures = {};

  std::optional<Vec3> stated_reflectance = {};  ///< what the file said, where load lowered it

  /// What was measured, in a scene that is solved by wavelength: instead of the colours above. Empty:
  /// nothing.
  Spectrum reflectance_spectrum = {};  ///< [0, 1)
  Spectrum emittance_spectrum = {};    ///< W/(m² nm), front side

  bool is_lamp() const {
    if (!emittance_spectrum.empty()) return emittance_spectrum.any_above_zero();
    return emittance.r > 0.0f || emittance.g > 0.0f || emittance.b > 0.0f;
  }
};

}  // namespace luxel
