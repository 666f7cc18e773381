// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace luxel {

// An uncompressed TGA file of 32 bits a pixel, from the top left: red, green, blue, alpha.
inline std::string small_tga(int width, int height, const std::vector<std::array<std::uint8_t, 4>>& pixels) {
  const auto byte = [](int n) { return static_cast<char>(n); };
  std::string bytes(18, '\0');
  bytes[2] = 2;  // true colour
  bytes[12] = byte(width);
  bytes[14] = byte(height);
  bytes[16] = 32;
  bytes[17] = 0x28;  // top first, eight bits of alpha
  for (const auto& [r, g, b, a] : pixels)
    for (const auto value : {b, g, r, a}) bytes += static_cast<char>(value);
  return bytes;
}

}  // namespace luxel
