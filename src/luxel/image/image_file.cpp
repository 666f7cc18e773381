// SPDX-License-Identifier: Apache-2.0
#include "luxel/image/image_file.h"

#include <algorithm>
#include <new>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "luxel/core/ending_of.h"
#include "luxel/core/error.h"
#include "luxel/core/output_file.h"
#include "luxel/image/codec.h"
#include "luxel/image/screen_image.h"

namespace luxel {
namespace fs = std::filesystem;
namespace {

constexpr std::uint64_t max_file = std::uint64_t{512} << 20;

// name: of the file, for errors.
template <typename Picture, typename Encode>
std::string encoded(const std::string& name, const Picture& image, const Encode& encode) {
  if (image.width < 1 || image.height < 1) throw cannot_write(name, "the picture has no pixels");
  try {
    return encode(image);
  } catch (const CodecError& e) {
    throw cannot_write(name, e.what());
  }
}

template <typename Picture, typename Encode>
void write_encoded(const fs::path& path, const Picture& image, const Encode& encode) {
  write_file(path, encoded(path.string(), image, encode));
}

// Only expected formats reach the decoder: stb supports more of them, less well tested.
Raster decode(const fs::path& path, std::string_view bytes) {
  const auto begins = [&](std::string_view magic) { return bytes.substr(0, magic.size()) == magic; };
  if (begins("\x89PNG\r\n\x1a\n")) return decode_png(bytes);
  if (begins("\x76\x2f\x31\x01")) return decode_exr(bytes);
  if (begins("#?RADIANCE") || begins("#?RGBE")) return decode_hdr(bytes);
  if (begins("\xff\xd8") || begins("BM") || ending_of(path) == ".tga") return decode_stb(bytes);
  if (begins("RIFF") && bytes.substr(0, 12).ends_with("WEBP")) return decode_webp(bytes);
  if (begins("\xabKTX"))
    throw CodecError(
        "the picture is KTX, which Luxel does not read; convert it by: ktx extract IN.ktx2 OUT.png");
  throw CodecError("it is no picture that can be read; expected PNG, JPEG, WebP, TGA, BMP, HDR or EXR");
}

}  // namespace

void check_size(std::int64_t width, std::int64_t height, std::size_t bytes) {
  if (width < 1 || height < 1) throw CodecError("the picture has no pixels");
  if (width > max_side || height > max_side)
    throw CodecError(fmt::format("the picture is {} x {} pixels, expected at most {} a side; make it smaller",
                                 width, height, max_side));
  if (width * height > std::max(always_allowed_pixels, pixels_per_byte * static_cast<std::int64_t>(bytes)))
    throw CodecError(
        fmt::format("the picture claims {} x {} pixels in {} bytes, expected at most {} pixels or "
                    "{} per byte; make it smaller",
                    width, height, bytes, always_allowed_pixels, pixels_per_byte));
}

void write_png(const fs::path& path, const Image& display, const PictureNotes& notes) {
  write_encoded(path, display, [&](const Image& image) { return encode_png(image, notes); });
}
void write_png(const fs::path& path, const ScreenImage& image) {
  write_encoded(path, image, [](const ScreenImage& codes) { return encode_png(codes); });
}
std::string png_of(const Image& display, const PictureNotes& notes, const Context& context) {
  return encoded("a PNG picture", display,
                 [&](const Image& image) { return encode_png(image, notes, context); });
}
std::string png_of(const Raster& raster) {
  return encoded("a PNG picture", raster, [](const Raster& picture) {
    return picture.codes.empty() ? encode_png(as_image(picture)) : encode_png(picture);
  });
}
void write_exr(const fs::path& path, const Image& linear) {
  write_encoded(path, linear, [](const Image& image) { return encode_exr(image); });
}
std::string exr_of(const Image& linear, const Context& context) {
  return encoded("an EXR picture", linear, [&](const Image& image) { return encode_exr(image, context); });
}
void write_hdr(const fs::path& path, const Image& linear) { write_encoded(path, linear, encode_hdr); }

Raster decode_raster(std::string_view bytes, const std::string& name) {
  try {
    return decode(name, bytes);
  } catch (const CodecError& e) {
    throw InputError(name, e.what());
  } catch (const std::bad_alloc&) {
    throw InputError(name, "the picture does not fit into memory; make it smaller");
  }
}

Raster read_raster(const fs::path& path) { return decode_raster(read_file(path, max_file), path.string()); }
Image read_image(const fs::path& path) { return as_image(read_raster(path)); }

}  // namespace luxel
