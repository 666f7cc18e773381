// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/scene/spectrum.h"

namespace luxel {

// Response of the eye to light by wavelength: the colour-matching functions of the CIE 1931 standard observer
// (2 degrees; ISO/CIE 11664-1), every 5 nm from 360 to 830 nm, zero beyond. y is the eye's sensitivity, 1 at
// 555 nm; the integral of each is 106.86 to 106.89 nm.
struct Observer {
  Spectrum x, y, z;
};
const Observer& cie_1931_observer();

inline constexpr double first_visible = 360.0;  // nm
inline constexpr double last_visible = 830.0;   // nm

// Daylight of 6504 K, CIE standard illuminant D65 (ISO/CIE 11664-2): relative power by wavelength, 100 at 560
// nm, every 5 nm from 360 to 830 nm. The white of sRGB.
const Spectrum& daylight_d65();

}  // namespace luxel
