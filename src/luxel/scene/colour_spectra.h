// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "luxel/core/vector.h"
#include "luxel/scene/band_colours.h"
#include "luxel/scene/spectrum.h"

namespace luxel {

inline constexpr double spectra_begin = 420.0;  // nm: wavebands that begin later, or
inline constexpr double spectra_end = 680.0;    // nm: end earlier, cannot carry every colour

// Smooth spectra at given wavebands for light and reflectances that are given as colours.
//
// White light is daylight (CIE D65), the white of sRGB, multiplied by a parabola that differs from 1 by about
// a per cent, so that its colour at these wavebands is exactly (1, 1, 1). A reflectance is a sigmoid of a
// parabola (Jakob and Hanika 2019), fitted such that it has the given colour in that light; a grey reflects
// all wavelengths equally. Light in a grey scene, and direct light from lamps, is therefore the same as in
// plain colour; light that has met coloured surfaces more than once differs.
class ColourSpectra {
 public:
  // Throws InputError where the wavebands do not reach from spectra_begin to spectra_end.
  explicit ColourSpectra(const std::vector<Waveband>& wavebands);

  // rgb: in [0, 1). Result: [band], in [0, 1). The colour comes out to 1e-6; of colours so deep that no
  // surface can have them at these wavebands, the nearest.
  std::vector<float> reflectance(const Vec3& rgb) const;
  // rgb: 0 or more, beyond 1 too. Result: [band], what gives white light this colour.
  std::vector<float> tint(const Vec3& rgb) const;
  // rgb: power, or its density (W, W/m², W/(m² sr)), by linear sRGB. Result: the same by band, [band].
  std::vector<float> light(const Vec3& rgb) const;

 private:
  std::vector<double> surface(const Vec3d& rgb) const;

  BandColours colours_;
  std::vector<Vec3d> powers_;  // [band]: 1, u and u² of the wavelength, u about -1 to 1
  std::vector<double> white_;  // [band], W/m² of light that is 1 in red, green and blue
};

}  // namespace luxel
