// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "luxel/core/vector.h"

namespace luxel {

// From dark to bright, for what is more or less; and from blue over white to red, for what is off to either
// side. Both keep their order for eyes that do not tell red from green.
enum class ColourMap { heat, difference };

// share: in [0, 1], clamped; NaN gives grey. Linear RGB in [0, 1].
Vec3 map_colour(ColourMap map, float fraction);

// How values become shares of a colour map.
struct ValueScale {
  float low = 0.0f, high = 1.0f;  // high above low; both above 0 where it is logarithmic
  bool logarithmic = false;
  int isolines = 0;  // at equal steps of the share, the ends not counted; 0: none
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
// What a person reads at a scale: three digits, without zeros at the end.
std::string scale_text(float value);

}  // namespace luxel
