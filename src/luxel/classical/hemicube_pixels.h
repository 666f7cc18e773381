// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace luxel {

// The form factor of each pixel of a hemicube, from the point under the cube to the pixel, in closed form
// over the whole pixel (Howell's catalogue, B-3 and B-4), so that all of them sum to 1.
struct HemicubePixels {
  int resolution = 0;
  std::vector<double> top;   // [row][column], resolution² of them, over [-1, 1]²
  std::vector<double> side;  // [row][column], resolution² / 2; row 0 stands on the horizon
};

// resolution: even, at least 2.
HemicubePixels make_hemicube_pixels(int resolution);

}  // namespace luxel
