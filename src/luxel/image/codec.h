// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

#include "luxel/image/image.h"

namespace luxel {

// The formats, in memory. The room's own: image_file.h adds the disk, the choice of format and the file's
// name.

inline constexpr int largest_side = 16384;  // pixels; more is refused before anything is decoded

// What is wrong with the bytes, still without the file's name.
struct CodecError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Throws CodecError unless 1 <= width, height <= largest_side.
void check_size(std::int64_t width, std::int64_t height);

// 8-bit sRGB RGB, tightly packed, as linear pixels.
Image image_from_codes(int width, int height, const std::uint8_t* rgb);

std::string encode_png(const Image& display);
std::string encode_exr(const Image& linear);
std::string encode_hdr(const Image& linear);

Image decode_png(std::string_view bytes);
Image decode_exr(std::string_view bytes);
Image decode_hdr(std::string_view bytes);
Image decode_stb(std::string_view bytes);  // JPEG, BMP, TGA

}  // namespace luxel
