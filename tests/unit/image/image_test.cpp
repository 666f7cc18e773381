// SPDX-License-Identifier: Apache-2.0
#include "luxel/image/image.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace luxel {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

// IEC 61966-2-1: the ends, a point of the straight part, and published values of the curve.
TEST(Srgb, the_curve_passes_through_its_known_points) {
  EXPECT_EQ(srgb_encode(0.0f), 0.0f);
  EXPECT_EQ(srgb_encode(1.0f), 1.0f);
  EXPECT_NEAR(srgb_encode(0.001f), 0.01292f, 1e-8f);
  EXPECT_NEAR(srgb_encode(0.5f), 0.7353569f, 1e-6f);
  EXPECT_NEAR(srgb_encode(0.18f), 0.4613561f, 1e-6f);
  EXPECT_NEAR(srgb_decode(0.5f), 0.2140411f, 1e-7f);
  EXPECT_NEAR(srgb_decode(0.04045f), 0.04045f / 12.92f, 1e-9f);
}

TEST(Srgb, decoding_undoes_encoding) {
  for (int i = 0; i <= 1000; ++i) {
    const float v = static_cast<float>(i) / 1000.0f;
    EXPECT_NEAR(srgb_decode(srgb_encode(v)), v, 2e-7f) << v;
  }
}

TEST(Srgb, each_of_the_256_codes_comes_back) {
  for (int code = 0; code < 256; ++code)
    EXPECT_EQ(srgb_code(srgb_decode(static_cast<float>(code) / 255.0f)), code);
}

TEST(Srgb, a_code_is_the_encoded_value_rounded) {
  for (int i = 0; i <= 100'000; ++i) {
    const float v = static_cast<float>(i) / 100'000.0f;
    const double exact = 255.0 * static_cast<double>(srgb_encode(v));
    EXPECT_LE(std::abs(exact - srgb_code(v)), 0.5001) << v;
  }
}

TEST(Srgb, values_out_of_range_are_clamped) {
  EXPECT_EQ(srgb_encode(-1.0f), 0.0f);
  EXPECT_EQ(srgb_encode(infinity), 1.0f);
  EXPECT_EQ(srgb_encode(nan), 0.0f);
  EXPECT_EQ(srgb_decode(-infinity), 0.0f);
  EXPECT_EQ(srgb_decode(2.0f), 1.0f);
  EXPECT_EQ(srgb_decode(nan), 0.0f);
  EXPECT_EQ(srgb_code(-infinity), 0);
  EXPECT_EQ(srgb_code(7.0f), 255);
  EXPECT_EQ(srgb_code(nan), 0);
}

TEST(Image, pixels_run_row_by_row_from_the_top_left) {
  Image image(3, 2, Vec3(0.5f));
  image.at(2, 1) = Vec3(1.0f, 2.0f, 3.0f);
  EXPECT_EQ(image.pixels.size(), 6u);
  EXPECT_EQ(image.pixels[5], Vec3(1.0f, 2.0f, 3.0f));
  EXPECT_EQ(image.at(0, 0), Vec3(0.5f));
}

TEST(Image, the_mean_color_is_exact_where_float_sums_would_stall) {
  Image image(32, 32, Vec3(1.0f, 0.0f, 0.25f));
  image.at(0, 0).r = 33554432.0f;  // 2^25: in float, adding 1 changes nothing
  EXPECT_EQ(mean_color(image), Vec3(static_cast<float>(33555455.0 / 1024.0), 0.0f, 0.25f));
}

TEST(Image, the_mean_color_of_nothing_is_black) { EXPECT_EQ(mean_color(Image()), Vec3(0.0f)); }

}  // namespace
}  // namespace luxel
