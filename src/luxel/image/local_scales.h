// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace luxel {

// Constants of the search for the local adaptation luminance of a pixel (Reinhard et al. 2002, section 3.2),
// for the implementations on the processor and on a graphics card. Scale i has s = ratio^i pixels; its centre
// is blurred by smallest * ratio^i, its surround is the centre of the scale after it.
struct LocalScales {
  static constexpr int count = 8;          // s = 1 to 27; the surround of the last is 43
  static constexpr int blurs = count + 1;  // that serve them
  static constexpr double ratio = 1.6;     // of surround to centre, and of each scale to the one before
  static constexpr double phi = 8.0;       // sharpness
  static constexpr float epsilon = 0.05f;  // contrast of centre and surround that ends the search
  // Standard deviation at s = 1, pixels: alpha_1 / sqrt(2), alpha_1 = 1 / (2 sqrt(2)).
  static constexpr double smallest = 0.25;
  // Curve inputs above are equally white; a lamp or an infinity must not make a surround of infinity.
  static constexpr float brightest = 1e6f;
};

}  // namespace luxel
