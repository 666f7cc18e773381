// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstring>
#include <memory>
#include <vector>

#include <fmt/format.h>
#include <stb_image.h>
#include <stb_image_write.h>

#include "luxel/image/codec.h"

namespace luxel {
namespace {

struct Free {
  void operator()(void* pixels) const { stbi_image_free(pixels); }
};

[[noreturn]] void refuse() {
  const auto* reason = stbi_failure_reason();
  throw CodecError(fmt::format("the picture is damaged: {}", reason ? reason : "no reason is known"));
}

// Appends to the std::string at `to`.
void append(void* to, void* data, int size) {
  static_cast<std::string*>(to)->append(static_cast<const char*>(data), static_cast<std::size_t>(size));
}

}  // namespace

std::string encode_jpeg(const Raster& raster, int quality) {
  std::vector<std::uint8_t> rgb;
  rgb.reserve(3 * raster.codes.size());
  for (const auto& code : raster.codes) rgb.insert(rgb.end(), code.begin(), code.begin() + 3);
  std::string bytes;
  if (!stbi_write_jpg_to_func(append, &bytes, raster.width, raster.height, 3, rgb.data(), quality))
    throw CodecError("the picture cannot be written as JPEG");
  return bytes;
}

std::string encode_hdr(const Image& linear) {
  // Below 2^127, where the shared exponent of a pixel ends.
  constexpr float largest = 1e38f;
  std::vector<float> rgb;
  rgb.reserve(3 * linear.pixels.size());
  for (const auto& pixel : linear.pixels)
    for (int c = 0; c < 3; ++c) rgb.push_back(pixel[c] > 0.0f ? std::min(pixel[c], largest) : 0.0f);

  std::string bytes;
  if (!stbi_write_hdr_to_func(append, &bytes, linear.width, linear.height, 3, rgb.data()))
    throw CodecError("the picture cannot be written as Radiance HDR");
  return bytes;
}

Raster decode_stb(std::string_view bytes) {
  const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
  const auto size = static_cast<int>(bytes.size());
  int width = 0, height = 0, channels = 0;
  if (!stbi_info_from_memory(data, size, &width, &height, &channels)) refuse();
  check_size(width, height, bytes.size());
  const std::unique_ptr<stbi_uc, Free> rgba(stbi_load_from_memory(data, size, &width, &height, &channels, 4));
  if (!rgba) refuse();
  Raster raster{width, height, {}, {}};
  raster.codes.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  std::memcpy(raster.codes.data(), rgba.get(), raster.codes.size() * sizeof(Raster::Code));
  return raster;
}

}  // namespace luxel
