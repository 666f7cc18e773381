// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "luxel/core/error.h"
#include "luxel/core/output_file.h"
#include "luxel/image/image_file.h"
#include "luxel/image/screen_image.h"

namespace luxel {
namespace {
namespace fs = std::filesystem;

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

using Writer = void (*)(const fs::path&, const Image&);

fs::path path(const std::string& name) { return fs::path(testing::TempDir()) / ("write_image." + name); }

// All three channels over ten powers of ten, no two pixels alike.
Image steps() {
  Image image(37, 11);
  float v = 1e-5f;
  for (auto& pixel : image.pixels) {
    pixel = Vec3(v, 0.7f * v, 0.05f * v);
    v *= 1.055f;
  }
  return image;
}

std::string refusal(Writer write, const fs::path& to, const Image& image = steps()) {
  try {
    write(to, image);
  } catch (const DeviceError& e) {
    return e.what();
  }
  return "written without complaint";
}

TEST(WritePng, every_code_of_every_channel_is_read_back) {
  Image image(256, 3);
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 256; ++x) image.at(x, y)[y] = srgb_decode(static_cast<float>(x) / 255.0f);
  write_png(path("codes.png"), image);
  const auto back = read_image(path("codes.png"));
  EXPECT_EQ(back.width, 256);
  EXPECT_EQ(back.height, 3);
  EXPECT_EQ(back.pixels, image.pixels);
}

TEST(WritePng, codes_of_a_screen_are_written_as_they_are) {
  ScreenImage screen{16, 16, {}};
  for (int i = 0; i < 3 * 256; ++i) screen.codes.push_back(static_cast<std::uint8_t>(i * 7 % 256));
  write_png(path("screen.png"), screen);
  const auto back = read_image(path("screen.png"));
  ASSERT_EQ(back.pixels.size(), 256u);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x)
      for (int c = 0; c < 3; ++c)
        EXPECT_EQ(srgb_code(back.at(x, y)[c]),
                  screen.codes[screen.index(x, y) + static_cast<std::size_t>(c)]);
  EXPECT_THROW(write_png(path("nothing.png"), ScreenImage()), DeviceError);
}

TEST(WritePng, a_file_says_it_is_srgb_and_not_when_it_was_made) {
  write_png(path("chunks.png"), steps());
  const auto bytes = read_file(path("chunks.png"));
  EXPECT_NE(bytes.find("sRGB"), std::string::npos);
  EXPECT_EQ(bytes.find("tIME"), std::string::npos);
}

TEST(WritePng, what_cannot_be_shown_is_clamped) {
  Image image(4, 1);
  image.pixels = {Vec3(nan), Vec3(infinity), Vec3(-infinity), Vec3(2.0f, -1.0f, nan)};
  write_png(path("clamped.png"), image);
  const auto back = read_image(path("clamped.png"));
  EXPECT_EQ(back.pixels, (std::vector{Vec3(0.0f), Vec3(1.0f), Vec3(0.0f), Vec3(1.0f, 0.0f, 0.0f)}));
}

// The monitor is polled at least every million codes; after its stop there is no file.
TEST(WriteImage, can_be_stopped_on_the_way) {
  const Image image(2000, 700, Vec3(0.5f));
  for (const bool as_png : {true, false}) {
    int asked = 0;
    const auto made = [&](int last) {
      const auto context =
          Context().with_monitor([&](const Progress&) { return ++asked < last ? Next::go_on : Next::stop; });
      asked = 0;
      return as_png ? png_of(image, {}, context) : exr_of(image, context);
    };
    EXPECT_FALSE(made(1000).empty());
    EXPECT_GE(asked, 3);
    EXPECT_TRUE(made(2).empty());
    EXPECT_EQ(asked, 2);
  }
}

TEST(WriteImage, in_memory_a_picture_without_pixels_is_refused_too) {
  EXPECT_THROW(png_of(Image()), DeviceError);
  EXPECT_THROW(png_of(Raster()), DeviceError);
  EXPECT_THROW(exr_of(Image()), DeviceError);
}

// Half floats have 11 significant bits from 6.1e-5 on, so rounding costs at most 2^-11; below, steps of
// 2^-24.
TEST(WriteExr, values_are_read_back_within_a_half) {
  const auto image = steps();
  write_exr(path("steps.exr"), image);
  const auto back = read_image(path("steps.exr"));
  ASSERT_EQ(back.pixels.size(), image.pixels.size());
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      const float v = std::min(image.pixels[i][c], 65504.0f);
      EXPECT_NEAR(back.pixels[i][c], v, std::max(v / 2048.0f, 3e-8f));
    }
}

TEST(WriteExr, values_beyond_a_half_are_the_largest_and_nan_is_black) {
  Image image(2, 1);
  image.pixels = {Vec3(nan, infinity, -infinity), Vec3(1e30f, -0.5f, 65504.0f)};
  write_exr(path("clamped.exr"), image);
  const auto back = read_image(path("clamped.exr"));
  EXPECT_EQ(back.pixels, (std::vector{Vec3(0.0f, 65504.0f, -65504.0f), Vec3(65504.0f, -0.5f, 65504.0f)}));
}

// A pixel has one exponent and eight bits a channel, cut not rounded: the error is below 1/128 of the
// largest.
TEST(WriteHdr, values_are_read_back_within_a_shared_exponent) {
  const auto image = steps();
  write_hdr(path("steps.hdr"), image);
  const auto back = read_image(path("steps.hdr"));
  ASSERT_EQ(back.pixels.size(), image.pixels.size());
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(back.pixels[i][c], image.pixels[i][c], image.pixels[i].r / 128.0f);
}

TEST(WriteHdr, what_the_format_cannot_hold_is_clamped) {
  Image image(3, 1);
  image.pixels = {Vec3(nan), Vec3(-1.0f), Vec3(infinity)};
  write_hdr(path("clamped.hdr"), image);
  const auto back = read_image(path("clamped.hdr"));
  EXPECT_EQ(back.pixels[0], Vec3(0.0f));
  EXPECT_EQ(back.pixels[1], Vec3(0.0f));
  EXPECT_NEAR(back.pixels[2].r, 1e38f, 1e36f);
}

class Writers : public testing::TestWithParam<std::pair<const char*, Writer>> {};

TEST_P(Writers, the_same_pixels_give_the_same_bytes) {
  const auto [ending, write] = GetParam();
  write(path(std::string("one") + ending), steps());
  write(path(std::string("two") + ending), steps());
  EXPECT_EQ(read_file(path(std::string("one") + ending)), read_file(path(std::string("two") + ending)));
}

TEST_P(Writers, one_pixel_is_a_picture) {
  const auto [ending, write] = GetParam();
  write(path(std::string("pixel") + ending), Image(1, 1, Vec3(1.0f, 0.0f, 1.0f)));
  const auto back = read_image(path(std::string("pixel") + ending));
  EXPECT_EQ(back.pixels, std::vector{Vec3(1.0f, 0.0f, 1.0f)});
}

TEST_P(Writers, a_picture_without_pixels_is_refused) {
  const auto [ending, write] = GetParam();
  const auto to = path(std::string("none") + ending);
  EXPECT_EQ(refusal(write, to, Image()), "cannot write " + to.string() + ": the picture has no pixels");
  EXPECT_FALSE(fs::exists(to));
}

TEST_P(Writers, a_missing_folder_is_named) {
  const auto [ending, write] = GetParam();
  const auto folder = path("missing");
  EXPECT_NE(refusal(write, folder / (std::string("a") + ending))
                .find("the folder '" + folder.string() + "' does not exist"),
            std::string::npos);
}

TEST_P(Writers, a_failed_write_leaves_nothing_behind) {
  const auto [ending, write] = GetParam();
  const auto folder = path(std::string("folder") + (ending + 1));
  const auto target = folder / (std::string("a") + ending);
  fs::remove_all(folder);
  fs::create_directories(target);
  EXPECT_NE(refusal(write, target).find("it is a folder"), std::string::npos);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 1);
  EXPECT_TRUE(fs::is_empty(target));
}

TEST_P(Writers, a_full_device_is_an_error) {
  EXPECT_EQ(refusal(GetParam().second, "/dev/full"), "cannot write /dev/full: No space left on device");
}

void write_plain_png(const fs::path& file, const Image& image) { write_png(file, image); }

INSTANTIATE_TEST_SUITE_P(Formats, Writers,
                         testing::Values(std::pair(".png", &write_plain_png), std::pair(".exr", &write_exr),
                                         std::pair(".hdr", &write_hdr)),
                         [](const auto& format) { return std::string(format.param.first + 1); });

}  // namespace
}  // namespace luxel
