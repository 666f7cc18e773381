// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "luxel/core/context.h"
#include "luxel/image/image.h"
#include "luxel/image/image_file.h"
#include "luxel/image/raster.h"

namespace luxel {

struct ScreenImage;

// The formats, in memory. The room's own: image_file.h adds the disk, the choice of format and the file's
// name.

inline constexpr int max_side = 16384;  // pixels; more is refused before anything is decoded

// An error in the bytes; its text does not yet name the file.
struct CodecError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// A file of n bytes may have max(2^24, 64 n) pixels: a plain colour compresses further, and a few kilobytes
// could require gigabytes.
inline constexpr std::int64_t always_allowed_pixels = 1 << 24, pixels_per_byte = 64;

// Throws CodecError unless 1 <= width, height <= max_side, and a file of this size may have the pixels.
void check_size(std::int64_t width, std::int64_t height, std::size_t bytes);

// The pixels of a file of linear values.
inline Raster of_numbers(Image image) { return {image.width, image.height, {}, std::move(image.pixels)}; }

// Empty where the monitor stops the work; here and below.
std::string encode_png(const Image& display, const PictureNotes& notes = {}, const Context& context = {});
std::string encode_png(const ScreenImage& image);
std::string encode_png(const Raster& raster);  // of codes
// Encodes a raster's codes, without alpha. quality: 1 to 100.
std::string encode_jpeg(const Raster& raster, int quality);
std::string encode_exr(const Image& linear, const Context& context = {});
std::string encode_hdr(const Image& linear);

Raster decode_png(std::string_view bytes);
Raster decode_exr(std::string_view bytes);
Raster decode_hdr(std::string_view bytes);
Raster decode_stb(std::string_view bytes);   // JPEG, BMP, TGA
Raster decode_webp(std::string_view bytes);  // refuses where Luxel was built without libwebp

}  // namespace luxel
