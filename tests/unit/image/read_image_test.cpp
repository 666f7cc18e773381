// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <stb_image_write.h>

#include "luxel/core/error.h"
#include "luxel/core/output_file.h"
#include "luxel/image/image_file.h"

namespace luxel {
namespace {
namespace fs = std::filesystem;

fs::path path(const std::string& name) { return fs::path(testing::TempDir()) / ("read_image." + name); }

Image picture() {
  Image image(9, 5);
  for (int y = 0; y < 5; ++y)
    for (int x = 0; x < 9; ++x) image.at(x, y) = 0.1f * Vec3(x, y, 9 - x);
  return image;
}

std::string bytes_of(const std::string& ending) {
  const auto file = path("source" + ending);
  if (ending == ".png") write_png(file, picture());
  if (ending == ".exr") write_exr(file, picture());
  if (ending == ".hdr") write_hdr(file, picture());
  return read_file(file);
}

Image read_bytes(const std::string& bytes, const std::string& ending) {
  const auto file = path("bytes" + ending);
  // Neither write_file() nor over the old file: both wait for the disk, thousands of times.
  fs::remove(file);
  std::ofstream(file, std::ios::binary) << bytes;
  return read_image(file);
}

// The error about the bytes; empty where they were read.
std::string complaint(const std::string& bytes, const std::string& ending) {
  try {
    read_bytes(bytes, ending);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

std::string big_endian(unsigned v) {
  return {static_cast<char>(v >> 24), static_cast<char>(v >> 16), static_cast<char>(v >> 8),
          static_cast<char>(v)};
}

unsigned crc32(const std::string& bytes) {  // ISO 3309, as in the PNG specification, annex D
  unsigned crc = ~0u;
  for (const char byte : bytes) {
    crc ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ (crc & 1 ? 0xedb88320u : 0u);
  }
  return ~crc;
}

std::string chunk(const std::string& type, const std::string& data) {
  return big_endian(static_cast<unsigned>(data.size())) + type + data + big_endian(crc32(type + data));
}

// A PNG of `rows` (each with its leading filter byte) in one stored deflate block.
std::string raw_png(unsigned width, unsigned height, int depth, int color, const std::string& rows,
                    const std::string& more_chunks = "") {
  unsigned a = 1, b = 0;  // Adler-32
  for (const char byte : rows) {
    a = (a + static_cast<unsigned char>(byte)) % 65521;
    b = (b + a) % 65521;
  }
  const auto n = static_cast<unsigned>(rows.size());
  const std::string length = {static_cast<char>(n), static_cast<char>(n >> 8), static_cast<char>(~n),
                              static_cast<char>(~n >> 8)};
  const auto header = big_endian(width) + big_endian(height) +
                      std::string{static_cast<char>(depth), static_cast<char>(color), 0, 0, 0};
  return "\x89PNG\r\n\x1a\n" + chunk("IHDR", header) + more_chunks +
         chunk("IDAT", "\x78\x01\x01" + length + rows + big_endian((b << 16) | a)) + chunk("IEND", "");
}

float code(int c) { return srgb_decode(static_cast<float>(c) / 255.0f); }

TEST(ReadImage, a_png_cut_at_any_byte_is_an_error) {
  const auto bytes = bytes_of(".png");
  for (std::size_t n = 0; n < bytes.size(); ++n)
    EXPECT_NE(complaint(bytes.substr(0, n), ".png").find("read_image.bytes.png: "), std::string::npos) << n;
}

TEST(ReadImage, a_png_damaged_at_any_byte_is_an_error) {
  const auto bytes = bytes_of(".png");
  for (std::size_t n = 0; n < bytes.size(); ++n)
    for (const int flip : {0x01, 0x80, 0xff}) {
      auto damaged = bytes;
      damaged[n] = static_cast<char>(damaged[n] ^ flip);
      EXPECT_NE(complaint(damaged, ".png"), "") << "byte " << n << " flipped by " << flip;
    }
}

// These formats have no checksum: a wrong pixel cannot be detected, but there is no crash and no NaN.
TEST(ReadImage, a_damaged_exr_or_hdr_is_an_error_or_a_picture) {
  for (const std::string ending : {".exr", ".hdr"}) {
    const auto bytes = bytes_of(ending);
    for (std::size_t n = 0; n < bytes.size(); ++n) {
      auto damaged = bytes;
      damaged[n] = static_cast<char>(damaged[n] ^ 0xff);
      try {
        for (const auto& pixel : read_bytes(damaged, ending).pixels) ASSERT_TRUE(is_finite(pixel));
      } catch (const InputError& e) {
        EXPECT_NE(std::string(e.what()).find("read_image.bytes" + ending + ": "), std::string::npos);
      }
    }
  }
}

TEST(ReadImage, a_cut_exr_or_hdr_is_an_error) {
  for (const std::string ending : {".exr", ".hdr"}) {
    const auto bytes = bytes_of(ending);
    for (std::size_t n = 0; n < bytes.size(); ++n)
      EXPECT_NE(complaint(bytes.substr(0, n), ending), "") << ending << " cut at " << n;
  }
}

TEST(ReadImage, an_hdr_may_mix_packed_and_plain_rows) {
  const std::string header = "#?RGBE\n# a remark\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 8\n";
  // Exponent 129 and mantissa 128: 128 * 2^(129 - 136) = 1. Red runs, green is dumped, blue runs in two
  // parts.
  const auto packed = std::string("\2\2\0\10", 4) + "\x88\x80" + std::string("\10\0\0\0\0\0\0\0\x40", 9) +
                      std::string("\x83\0\x85\0", 4) + "\x88\x81";
  std::string plain;
  for (int i = 0; i < 8; ++i) plain += std::string("\x80\x40\0\x82", 4);
  const auto image = read_bytes(header + packed + plain, ".hdr");
  EXPECT_EQ(image.at(0, 0), Vec3(1.0f, 0.0f, 0.0f));
  EXPECT_EQ(image.at(7, 0), Vec3(1.0f, 0.5f, 0.0f));
  for (int x = 0; x < 8; ++x) EXPECT_EQ(image.at(x, 1), Vec3(2.0f, 1.0f, 0.0f));
}

TEST(ReadImage, a_giant_declared_size_is_refused_before_decoding) {
  EXPECT_NE(complaint(raw_png(16385, 1, 8, 2, ""), ".png").find("16385 x 1 pixels, expected at most 16384"),
            std::string::npos);
  EXPECT_NE(complaint(raw_png(1, 2'000'000'000, 8, 2, ""), ".png").find("1 x 2000000000 pixels"),
            std::string::npos);
  EXPECT_NE(complaint("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 100000 +X 100000\n", ".hdr")
                .find("100000 x 100000 pixels"),
            std::string::npos);
  const auto exr = std::string("\x76\x2f\x31\x01\x02\0\0\0", 8) +
                   std::string("dataWindow\0box2i\0\x10\0\0\0", 21) +
                   std::string("\0\0\0\0\0\0\0\0\xff\xff\xff\x1f\x02\0\0\0", 16);
  EXPECT_NE(complaint(exr, ".exr").find("536870912 x 3 pixels"), std::string::npos) << complaint(exr, ".exr");
}

// OpenEXR would allocate the two gigabytes first. The attribute is the first one, of one or of several parts.
TEST(ReadImage, a_giant_attribute_of_an_exr_is_refused_before_it_is_allocated) {
  for (const char flags : {'\x00', '\x10'}) {
    const std::string header = std::string("\x76\x2f\x31\x01\x02", 5) + flags + std::string("\0\0", 2);
    const auto file = header + std::string(
                                   "s\0s\0\xf0\xff\xff\x7f"
                                   "abc",
                                   11);
    EXPECT_NE(complaint(file, ".exr").find("larger than the file"), std::string::npos);
  }
}

// OpenEXR reads a list of channels to its end, wherever that is.
TEST(ReadImage, an_attribute_of_an_exr_is_as_long_as_its_type) {
  const std::string header("\x76\x2f\x31\x01\x02\0\0\0", 8);
  const auto list = std::string("c\0chlist\0\x04\0\0\0R\0\0\0", 17);
  const auto number = std::string("n\0float\0\x03\0\0\0abc", 15);
  for (const auto& attribute : {list, number})
    EXPECT_NE(complaint(header + attribute, ".exr").find("wrong length"), std::string::npos);
}

TEST(ReadImage, many_pixels_in_few_bytes_are_refused_before_decoding) {
  EXPECT_NE(complaint(raw_png(16'000, 16'000, 8, 2, ""), ".png").find("16000 x 16000 pixels in"),
            std::string::npos);
}

TEST(ReadImage, a_grey_png_is_grey) {
  const auto image = read_bytes(raw_png(2, 1, 8, 0, std::string("\0\x80\xff", 3)), ".png");
  EXPECT_EQ(image.pixels, (std::vector{Vec3(code(0x80)), Vec3(1.0f)}));
}

TEST(ReadImage, one_bit_a_pixel_is_black_or_white) {
  const auto image = read_bytes(raw_png(3, 1, 1, 0, std::string("\0\xa0", 2)), ".png");
  EXPECT_EQ(image.pixels, (std::vector{Vec3(1.0f), Vec3(0.0f), Vec3(1.0f)}));
}

TEST(ReadImage, alpha_is_dropped_and_color_stays) {
  const auto image = read_bytes(raw_png(1, 1, 8, 6, std::string("\0\x10\x20\x30\0", 5)), ".png");
  EXPECT_EQ(image.pixels, std::vector{Vec3(code(0x10), code(0x20), code(0x30))});
}

TEST(ReadImage, a_palette_with_transparency_gives_its_colors) {
  const auto palette = chunk("PLTE", "\x10\x20\x30\x40\x50\x60") + chunk("tRNS", "\x01");
  const auto image = read_bytes(raw_png(2, 1, 8, 3, std::string("\0\x01\0", 3), palette), ".png");
  EXPECT_EQ(image.pixels, (std::vector{Vec3(code(0x40), code(0x50), code(0x60)),
                                       Vec3(code(0x10), code(0x20), code(0x30))}));
}

TEST(ReadImage, sixteen_bits_are_rounded_to_eight) {
  const auto image = read_bytes(raw_png(1, 1, 16, 2, std::string("\0\x40\x40\x80\x80\xff\xff", 7)), ".png");
  EXPECT_EQ(image.pixels, std::vector{Vec3(code(0x40), code(0x80), 1.0f)});
}

TEST(ReadImage, a_tga_is_told_by_its_ending) {
  std::string tga(18, '\0');
  tga[2] = 2;             // true colour, not packed
  tga[12] = 1;            // width
  tga[14] = 1;            // height
  tga[16] = 24;           // bits a pixel
  tga += "\x30\x20\x10";  // blue, green, red
  EXPECT_EQ(read_bytes(tga, ".TGA").pixels, std::vector{Vec3(code(0x10), code(0x20), code(0x30))});
  EXPECT_NE(complaint(tga, ".png").find("it is no picture that can be read"), std::string::npos);
}

TEST(ReadImage, a_bmp_is_read) {
  std::string bmp = "BM";
  const auto little = [&](unsigned v, int bytes) {
    for (int i = 0; i < bytes; ++i) bmp.push_back(static_cast<char>(v >> (8 * i)));
  };
  for (const unsigned v : {58u, 0u, 54u, 40u, 1u, 1u}) little(v, 4);  // sizes, start of pixels, width, height
  little(1, 2);
  little(24, 2);
  for (int i = 0; i < 6; ++i) little(0, 4);
  bmp += std::string("\x30\x20\x10\0", 4);
  EXPECT_EQ(read_bytes(bmp, ".bmp").pixels, std::vector{Vec3(code(0x10), code(0x20), code(0x30))});
}

TEST(ReadImage, a_jpeg_is_read) {
  std::vector<std::uint8_t> codes;
  for (int i = 0; i < 16 * 16; ++i) codes.insert(codes.end(), {200, 100, 50});
  const auto file = path("orange.jpg");
  ASSERT_TRUE(stbi_write_jpg(file.c_str(), 16, 16, 3, codes.data(), 100));
  const auto image = read_image(file);
  EXPECT_EQ(image.pixels.size(), 256u);
  for (const auto& pixel : image.pixels) {
    EXPECT_NEAR(255.0f * srgb_encode(pixel.r), 200.0f, 2.1f);
    EXPECT_NEAR(255.0f * srgb_encode(pixel.g), 100.0f, 2.1f);
    EXPECT_NEAR(255.0f * srgb_encode(pixel.b), 50.0f, 2.1f);
  }
}

TEST(ReadImage, a_text_is_no_picture) {
  EXPECT_NE(complaint("hello", ".png").find("expected PNG, JPEG, WebP, TGA, BMP, HDR or EXR"),
            std::string::npos);
}

TEST(ReadImage, a_missing_file_is_named) {
  try {
    read_image("no/such/wall.png");
    FAIL() << "read without complaint";
  } catch (const InputError& e) {
    EXPECT_STREQ(e.what(), "no/such/wall.png: cannot read it: No such file or directory");
  }
}

}  // namespace
}  // namespace luxel
