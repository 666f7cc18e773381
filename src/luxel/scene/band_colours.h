// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "luxel/core/vector.h"
#include "luxel/scene/spectrum.h"

namespace luxel {

// Colours of light of several bands: the only conversion from bands to linear sRGB and lumens.
//
// Plain colour is linear sRGB already. Wavebands, W in each, are weighted by the CIE 1931 observer into X, Y
// and Z at 683 lm/W, converted to linear sRGB (IEC 61966-2-1, white D65) and divided by the 179 lm/W that RGB
// uses (luminous_efficacy.h). 179 times the luminance of the colour is therefore 683 lm/W times Y, and a
// spectrum and the plain colour of the same name give the same lumens and pictures of the same brightness.
// For a spectrum that is linear between the wavebands the colour is exact.
//
// Colours outside sRGB have a negative component, which linear sums need. in_gamut() is for display.
class BandColours {
 public:
  // Empty: plain colour, three bands.
  explicit BandColours(const std::vector<Waveband>& wavebands);

  std::size_t bands() const { return of_band_.size(); }
  // Linear sRGB of 1 in a band.
  const Vec3d& of(std::size_t band) const { return of_band_[band]; }

  // Converts W/m² (or W, or W/(m² sr)) by band, values[band], to the same unit by linear sRGB.
  template <typename Values>
  Vec3d rgb(const Values& values) const {
    Vec3d sum(0.0);
    for (std::size_t b = 0; b < of_band_.size(); ++b) sum += static_cast<double>(values[b]) * of_band_[b];
    return sum;
  }
  // Returns lumens of W by band, or lux of W/m² by band.
  template <typename Values>
  double lumens(const Values& values) const {
    return lumens_of(rgb(values));
  }

 private:
  static double lumens_of(const Vec3d& rgb);
  std::vector<Vec3d> of_band_;
};

// The colour of the same luminance that sRGB can show: grey is mixed in until no number is negative. One that
// has no luminance is black.
Vec3 in_gamut(const Vec3d& rgb);

}  // namespace luxel
