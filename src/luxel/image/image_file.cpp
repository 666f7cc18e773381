// SPDX-License-Identifier: Apache-2.0
#include "luxel/image/image_file.h"

#include <algorithm>
#include <cctype>
#include <new>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "luxel/file/output_file.h"
#include "luxel/image/codec.h"
#include "luxel/report/error.h"

namespace luxel {
namespace fs = std::filesystem;
namespace {

constexpr std::uint64_t largest_file = std::uint64_t{512} << 20;

void write_encoded(const fs::path& path, const Image& image, std::string (*encode)(const Image&)) {
  const auto refuse = [&](const std::string& reason) {
    throw DeviceError(fmt::format("cannot write {}: {}", path.string(), reason));
  };
  if (image.width < 1 || image.height < 1) refuse("the picture has no pixels");
  std::string bytes;
  try {
    bytes = encode(image);
  } catch (const CodecError& e) {
    refuse(e.what());
  }
  write_file(path, bytes);
}

bool ends_in_tga(const fs::path& path) {
  auto ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending == ".tga";
}

// Only formats asked for reach a decoder: stb knows more of them, less well tested.
Image decode(const fs::path& path, std::string_view bytes) {
  const auto begins = [&](std::string_view magic) { return bytes.substr(0, magic.size()) == magic; };
  if (begins("\x89PNG\r\n\x1a\n")) return decode_png(bytes);
  if (begins("\x76\x2f\x31\x01")) return decode_exr(bytes);
  if (begins("#?RADIANCE") || begins("#?RGBE")) return decode_hdr(bytes);
  if (begins("\xff\xd8") || begins("BM") || ends_in_tga(path)) return decode_stb(bytes);
  throw CodecError("it is no picture that can be read; expected PNG, JPEG, TGA, BMP, HDR or EXR");
}

}  // namespace

void check_size(std::int64_t width, std::int64_t height) {
  if (width < 1 || height < 1) throw CodecError("the picture has no pixels");
  if (width > largest_side || height > largest_side)
    throw CodecError(fmt::format("the picture is {} x {} pixels, expected at most {} a side; make it smaller",
                                 width, height, largest_side));
}

Image image_from_codes(int width, int height, const std::uint8_t* rgb) {
  float linear[256];
  for (int i = 0; i < 256; ++i) linear[i] = srgb_decode(static_cast<float>(i) / 255.0f);
  Image image(width, height);
  for (auto& pixel : image.pixels) {
    pixel = Vec3(linear[rgb[0]], linear[rgb[1]], linear[rgb[2]]);
    rgb += 3;
  }
  return image;
}

void write_png(const fs::path& path, const Image& display) { write_encoded(path, display, encode_png); }
void write_exr(const fs::path& path, const Image& linear) { write_encoded(path, linear, encode_exr); }
void write_hdr(const fs::path& path, const Image& linear) { write_encoded(path, linear, encode_hdr); }

Image read_image(const fs::path& path) {
  const auto bytes = read_file(path, largest_file);
  try {
    return decode(path, bytes);
  } catch (const CodecError& e) {
    throw InputError(path.string(), e.what());
  } catch (const std::bad_alloc&) {
    throw InputError(path.string(), "the picture does not fit into memory; make it smaller");
  }
}

}  // namespace luxel
