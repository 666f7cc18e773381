// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace luxel {

// An image for a screen: three sRGB codes per pixel (red, green, blue), row by row from the top left.
struct ScreenImage {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> codes;  // 3 * width * height

  std::size_t index(int x, int y) const { return 3 * (static_cast<std::size_t>(y) * width + x); }
};

// 8-bit sRGB PNG of these codes as they are; else as write_png() of image_file.h.
void write_png(const std::filesystem::path& path, const ScreenImage& image);

}  // namespace luxel
