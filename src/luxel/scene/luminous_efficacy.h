// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/core/vector.h"

namespace luxel {

// Photometric values exist only at the edges of the program, and all pass through this one number: lumens a
// watt of linear RGB white, the field's convention (Radiance's WHTEFFICACY; Ward 1994).
inline constexpr double luminous_efficacy = 179.0;  // lm/W

// Lumens of a power (W) by linear sRGB band, or lux of an irradiance (W/m²).
inline double lumens(double red, double green, double blue) {
  return luminous_efficacy * (0.2126 * red + 0.7152 * green + 0.0722 * blue);
}

}  // namespace luxel
