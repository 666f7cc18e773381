// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <csetjmp>
#include <cstring>
#include <new>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <png.h>

#include "luxel/image/codec.h"
#include "luxel/image/screen_image.h"

namespace luxel {
namespace {

// libpng leaves through longjmp, which must not skip a destructor of a C++ object. So all state that libpng
// touches is in this struct, and the functions that call libpng own nothing.
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

// Reads up to the size, so that check_size() runs before memory for pixels is allocated.
bool read_header(Decoder& decoder) {
  decoder.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &decoder, on_error, on_warning);
  if (!decoder.png) return false;
  if (setjmp(png_jmpbuf(decoder.png))) return false;
  decoder.info = png_create_info_struct(decoder.png);
  if (!decoder.info) return false;
  png_set_read_fn(decoder.png, &decoder, on_read);
  png_set_user_limits(decoder.png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);  // check_size() reports a better error
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

// CRC-32 as in the appendix of the PNG specification.
std::uint32_t cyclic_redundancy_check(std::string_view bytes) {
  std::uint32_t crc = 0xffffffffu;
  for (const auto byte : bytes) {
    crc ^= static_cast<std::uint8_t>(byte);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1u) ? 0xedb88320u : 0u);
  }
  return ~crc;
}

// A text chunk, inserted after the header once the picture is encoded: the encoder stays independent of the
// notes.
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

// State of the encoder, in a struct for the reason given at Decoder.
struct Encoder {
  png_structp png = nullptr;
  png_infop info = nullptr;
  std::string bytes;
  char problem[160] = "it cannot be written";

  ~Encoder() { png_destroy_write_struct(&png, &info); }
};

[[noreturn]] void on_encoder_error(png_structp png, png_const_charp message) {
  auto& encoder = *static_cast<Encoder*>(png_get_error_ptr(png));
  std::strncpy(encoder.problem, message, sizeof(encoder.problem) - 1);
  png_longjmp(png, 1);
}

bool append(std::string& bytes, png_const_bytep from, std::size_t size) {
  try {
    bytes.append(reinterpret_cast<const char*>(from), size);
    return true;
  } catch (const std::bad_alloc&) {
    return false;
  }
}

void on_write(png_structp png, png_bytep from, std::size_t size) {
  if (!append(static_cast<Encoder*>(png_get_io_ptr(png))->bytes, from, size))
    png_error(png, "it does not fit into memory");
}

// 8-bit sRGB codes.
bool write_header(Encoder& encoder, int width, int height, int channels) {
  encoder.png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &encoder, on_encoder_error, on_warning);
  if (!encoder.png) return false;
  if (setjmp(png_jmpbuf(encoder.png))) return false;
  encoder.info = png_create_info_struct(encoder.png);
  if (!encoder.info) return false;
  png_set_write_fn(encoder.png, &encoder, on_write, nullptr);
  png_set_IHDR(encoder.png, encoder.info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height),
               8, channels == 4 ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_sRGB(encoder.png, encoder.info, PNG_sRGB_INTENT_PERCEPTUAL);
  png_write_info(encoder.png, encoder.info);
  return true;
}

bool write_row(Encoder& encoder, const std::uint8_t* codes) {
  if (setjmp(png_jmpbuf(encoder.png))) return false;
  png_write_row(encoder.png, codes);
  return true;
}

bool write_end(Encoder& encoder) {
  if (setjmp(png_jmpbuf(encoder.png))) return false;
  png_write_end(encoder.png, encoder.info);
  return true;
}

// row(y): the codes of a row. Returns nothing where the monitor stops the work.
template <typename Row>
std::string encode_codes(int width, int height, int channels, const Row& row, const Context& context) {
  constexpr int codes_between_calls = 1 << 20;
  Encoder encoder;
  const auto refuse = [&] { throw CodecError(encoder.problem); };
  if (!write_header(encoder, width, height, channels)) refuse();
  const auto rows_between_calls = std::max(1, codes_between_calls / (channels * width));
  for (int y = 0; y < height; ++y) {
    if (y % rows_between_calls == 0 &&
        context.report({"pictures", static_cast<double>(y) / height}) == Next::stop)
      return {};
    if (!write_row(encoder, row(y))) refuse();
  }
  if (!write_end(encoder)) refuse();
  return std::move(encoder.bytes);
}

}  // namespace

std::string encode_png(const Image& display, const PictureNotes& notes, const Context& context) {
  std::vector<std::uint8_t> codes(3 * static_cast<std::size_t>(display.width));
  const auto row = [&](int y) {
    for (int x = 0; x < display.width; ++x)
      for (int c = 0; c < 3; ++c) codes[static_cast<std::size_t>(3 * x + c)] = srgb_code(display.at(x, y)[c]);
    return codes.data();
  };
  auto bytes = encode_codes(display.width, display.height, 3, row, context);
  if (bytes.empty()) return bytes;
  constexpr std::size_t end_of_header = 33;  // signature and IHDR
  for (auto note = notes.rbegin(); note != notes.rend(); ++note)
    bytes.insert(end_of_header, text_chunk(note->first, note->second));
  return bytes;
}

std::string encode_png(const ScreenImage& image) {
  const auto row = [&](int y) { return image.codes.data() + image.index(0, y); };
  return encode_codes(image.width, image.height, 3, row, {});
}

std::string encode_png(const Raster& raster) {
  const auto row = [&](int y) { return raster.codes[raster.index(0, y)].data(); };
  return encode_codes(raster.width, raster.height, 4, row, {});
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
  check_size(width, height, bytes.size());
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
