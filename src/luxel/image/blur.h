// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace luxel {

// One number a pixel, row by row: width * height of them.
struct GreyPicture {
  int width = 0;
  int height = 0;
  std::vector<float> values;
};

// The mean around each pixel with Gaussian weights of standard deviation sigma (pixels), cut at 3 sigma. Near
// an edge the weights inside the picture are brought back to a sum of 1, so a constant does not change. Two
// passes of 6 sigma + 1 taps per pixel. Up to rounding, the result lies between the smallest and the largest
// value.
GreyPicture gaussian_blur(const GreyPicture& plane, float sigma);

}  // namespace luxel
