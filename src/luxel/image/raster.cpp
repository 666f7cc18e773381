// SPDX-License-Identifier: Apache-2.0
#include "luxel/image/raster.h"

namespace luxel {
namespace {

const std::array<float, 256>& decoded() {
  static const auto table = [] {
    std::array<float, 256> linear;
    for (std::size_t i = 0; i < linear.size(); ++i) linear[i] = srgb_decode(static_cast<float>(i) / 255.0f);
    return linear;
  }();
  return table;
}

}  // namespace

Vec3 Raster::colour(std::size_t pixel) const {
  if (codes.empty()) return linear[pixel];
  const auto& table = decoded();
  const auto& code = codes[pixel];
  return {table[code[0]], table[code[1]], table[code[2]]};
}

Image as_image(const Raster& raster) {
  Image image(raster.width, raster.height);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = raster.colour(i);
  return image;
}

}  // namespace luxel
