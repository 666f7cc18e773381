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

  bool opaque = true;  ///< false: no surface; light passes (a pane of glass)
  /// Visible transmittance at normal incidence of a pane, which is not opaque: [0, 1]; 1: all light
  /// passes. A closed body of glass has it once, not at each of its two faces; see scene/glass.h.
  Vec3 transmittance = Vec3(1.0f);
  /// Diffuse transmittance of a thin sheet such as opal glass, fabric, paper or a blind: the fraction of the
  /// light on either side that leaves the other one, evenly in all directions; 0: none. Reciprocity makes it
  /// the same both ways. With the reflectance at most LoadOptions::max_reflectance. The material is opaque
  /// and two-sided: rays end on it.
  Vec3 diffuse_transmittance = Vec3(0.0f);

  /// Replace the colours above, which remain the means over the textures, for use of the material as a whole:
  /// the mean is above 0 in each band in which the texture is above 0 anywhere.
  MaterialTextures textures = {};

  std::optional<Vec3> stated_reflectance = {};  ///< the value in the file, if loading lowered it

  /// Measured spectra of a scene that is solved by wavelength; they replace the colours above. Empty: not
  /// measured.
  Spectrum reflectance_spectrum = {};  ///< [0, 1)
  Spectrum emittance_spectrum = {};    ///< W/(m² nm), front side

  bool is_diffuser() const { return diffuse_transmittance != Vec3(0.0f); }
  bool is_lamp() const {
    if (!emittance_spectrum.empty()) return emittance_spectrum.any_above_zero();
    return emittance.r > 0.0f || emittance.g > 0.0f || emittance.b > 0.0f;
  }
};

}  // namespace luxel
