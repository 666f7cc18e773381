// SPDX-License-Identifier: Apache-2.0
#include <csetjmp>
#include <cstring>
#include <vector>

#include <fmt/format.h>
#include <png.h>

#include "luxel/image/codec.h"
#include "luxel/image/screen_image.h"

namespace luxel {
namespace {

// libpng leaves through longjmp, which must not cross a C++ object that wants to be destroyed. So all that
// libpng touches lives here, and the functions that call it own nothing.
struct Decoder {
  png_structp png = nullptr;
  png_infop info = nullptr;
  std::string_view rest;  // not yet read
  char problem[160] = "it is damaged";

  ~Decoder() { png_destroy_read_struct(&png, &info, nullptr); }
};

[[noreturn]] void on_error(png_structp png, png_const_charp message) {
  auto& decoder = *static_cast<Decoder*>(png_get_error_ptr(png));
  std::strncpy(decoder.problem, message, sizeof(decoder.problem) - 1);
  png_longjmp(png, 1);
}

void on_warning(png_structp, png_const_charp) {}

void on_read(png_structp png, png_bytep to, std::size_t size) {
  auto& rest = static_cast<Decoder*>(png_get_io_ptr(png))->rest;
  if (size > rest.size()) png_error(png, "it ends too early");
  std::memcpy(to, rest.data(), size);
  rest.remove_prefix(size);
}

// Up to the size, which check_size() shall see before there is memory for pixels.
bool read_header(Decoder& decoder) {
  decoder.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &decoder, on_error, on_warning);
  if (!decoder.png) return false;
  if (setjmp(png_jmpbuf(decoder.png))) return false;
  decoder.info = png_create_info_struct(decoder.png);
  if (!decoder.info) return false;
  png_set_read_fn(decoder.png, &decoder, on_read);
  png_set_user_limits(decoder.png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);  // check_size() has the better words
  png_set_crc_action(decoder.png, PNG_CRC_ERROR_QUIT, PNG_CRC_ERROR_QUIT);
  png_read_info(decoder.png, decoder.info);
  return true;
}

// All kinds of PNG become 8-bit RGBA.
bool start_pixels(Decoder& decoder) {
  if (setjmp(png_jmpbuf(decoder.png))) return false;
  png_set_expand(decoder.png);
  png_set_scale_16(decoder.png);
  png_set_add_alpha(decoder.png, 0xff, PNG_FILLER_AFTER);
  png_set_gray_to_rgb(decoder.png);
  png_set_interlace_handling(decoder.png);
  png_read_update_info(decoder.png, decoder.info);
  return true;
}

bool read_pixels(Decoder& decoder, png_bytepp rows) {
  if (setjmp(png_jmpbuf(decoder.png))) return false;
  png_read_image(decoder.png, rows);
  png_read_end(decoder.png, nullptr);
  return true;
}

// As the PNG specification's appendix has it.
std::uint32_t cyclic_redundancy_check(std::string_view bytes) {
  std::uint32_t crc = 0xffffffffu;
  for (const auto byte : bytes) {
    crc ^= static_cast<std::uint8_t>(byte);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1u) ? 0xedb88320u : 0u);
  }
  return ~crc;
}

// libpng's simplified interface writes no text.
std::string text_chunk(const std::string& keyword, const std::string& text) {
  const auto number = [](std::uint32_t value) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 0xffu);
    return bytes;
  };
  std::string chunk = "tEXt";
  chunk += keyword;
  chunk += '\0';
  chunk += text;
  return number(static_cast<std::uint32_t>(chunk.size() - 4)) + chunk +
         number(cyclic_redundancy_check(chunk));
}

// libpng's simplified interface writes IHDR, sRGB, IDAT and IEND, and no time.
std::string encode_codes(int width, int height, png_uint_32 format, const void* codes) {
  png_image png = {};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(width);
  png.height = static_cast<png_uint_32>(height);
  png.format = format;
  std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(png), '\0');
  png_alloc_size_t size = bytes.size();
  if (!png_image_write_to_memory(&png, bytes.data(), &size, 0, codes, 0, nullptr))
    throw CodecError(png.message);
  bytes.resize(size);
  return bytes;
}

}  // namespace

std::string encode_png(const Image& display, const PictureNotes& notes) {
  std::vector<std::uint8_t> codes;
  codes.reserve(3 * display.pixels.size());
  for (const auto& pixel : display.pixels)
    for (int c = 0; c < 3; ++c) codes.push_back(srgb_code(pixel[c]));
  auto bytes = encode_codes(display.width, display.height, PNG_FORMAT_RGB, codes.data());
  constexpr std::size_t end_of_header = 33;  // signature and IHDR
  for (auto note = notes.rbegin(); note != notes.rend(); ++note)
    bytes.insert(end_of_header, text_chunk(note->first, note->second));
  return bytes;
}

std::string encode_png(const ScreenImage& image) {
  return encode_codes(image.width, image.height, PNG_FORMAT_RGB, image.codes.data());
}

std::string encode_png(const Raster& raster) {
  return encode_codes(raster.width, raster.height, PNG_FORMAT_RGBA, raster.codes.data());
}

Raster decode_png(std::string_view bytes) {
  Decoder decoder;
  decoder.rest = bytes;
  const auto refuse = [&] {
    throw CodecError(fmt::format("the PNG picture is damaged: {}", decoder.problem));
  };
  if (!read_header(decoder)) refuse();
  const auto width = png_get_image_width(decoder.png, decoder.info);
  const auto height = png_get_image_height(decoder.png, decoder.info);
  check_size(width, height);
  if (!start_pixels(decoder)) refuse();

  Raster raster{static_cast<int>(width), static_cast<int>(height), {}, {}};
  const std::size_t stride = png_get_rowbytes(decoder.png, decoder.info);
  if (stride != sizeof(Raster::Code) * width) throw CodecError("the PNG picture is of an unknown kind");
  raster.codes.resize(std::size_t{width} * height);
  std::vector<png_bytep> rows(height);
  for (std::size_t y = 0; y < height; ++y) rows[y] = raster.codes[y * width].data();
  if (!read_pixels(decoder, rows.data())) refuse();
  return raster;
}

}  // namespace luxel
