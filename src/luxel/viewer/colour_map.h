// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "luxel/core/vector.h"

namespace luxel {

// heat: from dark to bright, for amounts; difference: from blue over white to red, for deviations to either
// side. Both keep their order for viewers with red-green colour blindness.
enum class ColourMap { heat, difference };

// fraction: in [0, 1], clamped; NaN gives grey. Linear RGB in [0, 1].
Vec3 map_colour(ColourMap map, float fraction);

// Maps values to fractions of a colour map.
struct ValueScale {
  float low = 0.0f, high = 1.0f;  // high above low; both above 0 where it is logarithmic
  bool logarithmic = false;
  int isolines = 0;  // at equal steps of the fraction, without the ends; 0: none
  ColourMap map = ColourMap::heat;

  float fraction(float value) const;
  float value_at(float fraction) const;
};

// Returns a scale for these values with ends that are 1, 2 or 5 times a power of ten; values that are not
// finite are ignored. It covers 98 in 100 of them, so that a lone lamp does not darken the rest. difference:
// symmetric around 0. Cost: a selection among at most 20,000 of them.
ValueScale automatic_value_scale(const std::vector<float>& values, bool logarithmic, ColourMap map);

// 1, 2 or 5 times a power of ten, not below the value; for values above 0.
float round_up(float value);
// Text of a number at a scale: three digits, without trailing zeros.
std::string scale_text(float value);

}  // namespace luxel
