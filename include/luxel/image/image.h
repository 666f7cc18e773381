// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "luxel/core/vector.h"

namespace luxel {

/// Linear RGB pixels, row by row from the top left. Scene-referred (radiance, W/(m² sr)) or display-referred
/// ([0, 1]): the function that returns it documents which.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<Vec3> pixels;  ///< width * height

  Image() = default;
  Image(int w, int h, const Vec3& fill = Vec3(0.0f))
      : width(w), height(h), pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), fill) {}
  Vec3& at(int x, int y) {
    assert(x >= 0 && x < width && y >= 0 && y < height);
    return pixels[static_cast<std::size_t>(y) * width + x];
  }
  const Vec3& at(int x, int y) const {
    assert(x >= 0 && x < width && y >= 0 && y < height);
    return pixels[static_cast<std::size_t>(y) * width + x];
  }
};

/// The sRGB transfer function of IEC 61966-2-1, for one channel in [0, 1], and its inverse. Outside of that
/// range they are clamped; NaN gives 0.
float srgb_encode(float linear);
float srgb_decode(float encoded);

/// Returns 255 srgb_encode(linear), rounded: the code of an 8-bit file. The same on every host, and many
/// times faster.
std::uint8_t srgb_code(float linear);

/// The mean of all pixels (double sums), linear; black where there are none.
Vec3 mean_color(const Image& image);

}  // namespace luxel
