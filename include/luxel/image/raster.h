// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "luxel/image/image.h"

namespace luxel {

/// Pixels as a file holds them, row by row from the top left: 8-bit codes, or numbers where the file has
/// such.
struct Raster {
  using Code = std::array<std::uint8_t, 4>;  ///< red, green, blue by sRGB; alpha, linear

  int width = 0;
  int height = 0;
  std::vector<Code> codes;   ///< width * height, or none where there is `linear`
  std::vector<Vec3> linear;  ///< width * height: of EXR and HDR files, finite, opaque

  std::size_t index(int x, int y) const { return static_cast<std::size_t>(y) * width + x; }
  /// Linear sRGB of the file's colour, regardless of alpha.
  Vec3 colour(std::size_t pixel) const;
  /// [0, 1]
  float alpha(std::size_t pixel) const {
    return codes.empty() ? 1.0f : static_cast<float>(codes[pixel][3]) / 255.0f;
  }
};

/// PNG, JPEG, WebP, BMP, Radiance HDR, OpenEXR (recognised by their first bytes) or TGA (by its extension).
/// Deeper PNG files are reduced to 8 bits, grey becomes RGB; a file without alpha is opaque, and so are those
/// of linear values. In these NaN becomes 0 and infinity 65504. Throws InputError naming the file where it is
/// missing, damaged, of another format, larger than 512 MiB or than 16384 pixels per
/// side, or claims more than max(2^24, 64 per byte) pixels.
Raster read_raster(const std::filesystem::path& path);

/// Decodes a file in memory like read_raster(); errors call it `name`, whose extension identifies TGA.
Raster decode_raster(std::string_view bytes, const std::string& name);

/// Returns the whole raster without alpha.
Image as_image(const Raster& raster);

}  // namespace luxel
