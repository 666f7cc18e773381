// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "luxel/image/image.h"

namespace luxel {

// Mapping of values to colours: evenly from 0 to `high`, darker ones black, brighter ones the last colour.
struct FalseColourScale {
  double high = 1.0;  // above 0
  std::string unit;   // "lx" or "cd/m2"
};

// The colour of a fraction of a scale, from black over red to pale yellow in steps that look even: sRGB codes
// from 0 to 1.
Vec3 false_colour(double fraction);

// Returns a scale from 0 to the 98th percentile of the values above 0, rounded up to 1, 2 or 5 times a power
// of ten.
FalseColourScale automatic_scale(const std::vector<double>& values, const std::string& unit);

// A picture of values, row by row, in the colours of the scale, display-referred. Values that are no number
// are grey. A legend with six values covers the right edge where the picture is large enough, 240 x 180
// pixels. values.size() == width * height.
Image false_colours(const std::vector<double>& values, int width, int height, const FalseColourScale& scale);

}  // namespace luxel
