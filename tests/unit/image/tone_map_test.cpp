// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "luxel/image/tone.h"

namespace luxel {
namespace {

constexpr ToneOperator operators[] = {ToneOperator::neutral, ToneOperator::maximum, ToneOperator::clamp,
                                      ToneOperator::reinhard, ToneOperator::reinhard_local};

// A dark left and a bright right half, each with fine stripes of the same contrast.
Image halves(float bright, float contrast) {
  Image image(128, 64);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const float stripe = (x / 2) % 2 ? 1.0f + contrast : 1.0f - contrast;
      image.at(x, y) = Vec3((x < 64 ? 1.0f : bright) * stripe);
    }
  return image;
}

// (max - min) / (max + min) of one row from x0 to x1.
float contrast(const Image& image, int x0, int x1) {
  float low = image.at(x0, 32).g, high = low;
  for (int x = x0; x < x1; ++x) {
    low = std::min(low, image.at(x, 32).g);
    high = std::max(high, image.at(x, 32).g);
  }
  return (high - low) / (high + low);
}

TEST(ToneMap, the_global_operators_apply_their_fitted_curve_to_every_pixel) {
  const auto radiance = halves(100.0f, 0.3f);
  const std::vector<float> weights(radiance.pixels.size(), 1.0f);
  for (const auto op :
       {ToneOperator::neutral, ToneOperator::maximum, ToneOperator::clamp, ToneOperator::reinhard}) {
    const auto curve = fit_curve(radiance.pixels, weights, {.op = op});
    const auto display = tone_map(radiance, {.op = op});
    for (std::size_t p = 0; p < radiance.pixels.size(); ++p)
      EXPECT_EQ(display.pixels[p], curve(radiance.pixels[p]));
  }
}

TEST(ToneMap, half_a_pixel_of_a_bright_lamp_is_half_as_bright_as_the_lamp) {
  Image radiance(2, 1, Vec3(50.0f));
  const EdgePixels edges{2, {1}, {Vec3(100.0f), Vec3(0.0f)}};
  for (const auto op : {ToneOperator::neutral, ToneOperator::clamp, ToneOperator::reinhard}) {
    const ToneOptions options{.op = op, .scale = 1.0f};
    const auto display = tone_map(radiance, options, edges);
    const auto lamp = tone_map(Image(1, 1, Vec3(100.0f)), options).pixels[0].g;
    EXPECT_GT(lamp, 0.98f);
    EXPECT_FLOAT_EQ(display.pixels[1].g, 0.5f * lamp);
    EXPECT_GT(display.pixels[0].g, 0.97f);
  }
}

TEST(ToneMap, the_sky_has_a_look_of_its_own_and_no_part_in_the_exposure) {
  Image radiance(4, 1, Vec3(0.5f));
  radiance.pixels[0] = Vec3(300.0f);
  radiance.pixels[1] = Vec3(150.25f);  // half of it
  const SkyPixels sky{{0, 1}, {1.0f, 0.5f}, {Vec3(0.2f, 0.3f, 0.4f), Vec3(0.35f)}};
  EXPECT_EQ(exposure_weights(radiance, sky), (std::vector<float>{0.0f, 0.5f, 1.0f, 1.0f}));
  const auto curve = fit_curve(radiance.pixels, exposure_weights(radiance, sky));
  const auto display = tone_map(radiance, {}, {}, sky);
  EXPECT_EQ(display.pixels[0], curve(sky.radiance[0]));
  EXPECT_EQ(display.pixels[1], curve(sky.radiance[1]));
  EXPECT_EQ(display.pixels[2], curve(radiance.pixels[2]));
}

TEST(ToneMap, a_picture_of_the_sky_alone_is_exposed_for_the_sky) {
  const Image radiance(10, 10, Vec3(7.0f));
  SkyPixels sky;
  for (std::uint32_t p = 0; p < 100; ++p) {
    sky.pixels.push_back(p);
    sky.fraction.push_back(p < 99 ? 1.0f : 0.1f);
    sky.radiance.push_back(Vec3(7.0f));
  }
  EXPECT_EQ(exposure_weights(radiance, sky), std::vector<float>(100, 1.0f));
}

TEST(ReinhardLocal, equals_the_global_operator_on_a_constant_image) {
  const Image constant(50, 30, Vec3(3.0f, 2.0f, 1.0f));
  for (const float white : {0.0f, 0.5f}) {
    const auto global = tone_map(constant, {.op = ToneOperator::reinhard, .white = white});
    const auto local = tone_map(constant, {.op = ToneOperator::reinhard_local, .white = white});
    for (std::size_t p = 0; p < constant.pixels.size(); ++p)
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(local.pixels[p][c], global.pixels[p][c], 1e-6f);
  }
}

// In the bright half L >> 1. There the global curve divides a contrast by about 1 + L; the local one divides
// both stripes by the same surround and so keeps the contrast.
TEST(ReinhardLocal, keeps_detail_in_the_bright_half_that_the_global_operator_flattens) {
  const auto radiance = halves(1000.0f, 0.05f);
  const auto global = tone_map(radiance, {.op = ToneOperator::reinhard});
  const auto local = tone_map(radiance, {.op = ToneOperator::reinhard_local});
  EXPECT_LT(contrast(global, 80, 120), 0.01f);
  EXPECT_NEAR(contrast(local, 80, 120), 0.05f, 0.005f);
  EXPECT_NEAR(contrast(local, 8, 48), 0.05f, 0.005f);
}

TEST(ReinhardLocal, has_no_halo_of_the_bright_half_in_the_dark_half) {
  const auto radiance = halves(1000.0f, 0.0f);
  const auto display = tone_map(radiance, {.op = ToneOperator::reinhard_local});
  const float far_away = display.at(5, 32).g;
  for (int x = 0; x < 62; ++x) EXPECT_NEAR(display.at(x, 32).g, far_away, 0.1f * far_away) << x;
}

TEST(ReinhardLocal, is_the_same_left_to_right_and_top_to_bottom) {
  auto radiance = halves(30.0f, 0.2f);
  for (int x = 0; x < 128; ++x) radiance.at(x, 10) *= 5.0f;
  Image turned(128, 64);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 128; ++x) turned.at(127 - x, 63 - y) = radiance.at(x, y);
  const auto a = tone_map(radiance, {.op = ToneOperator::reinhard_local});
  const auto b = tone_map(turned, {.op = ToneOperator::reinhard_local});
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 128; ++x) EXPECT_NEAR(b.at(127 - x, 63 - y).g, a.at(x, y).g, 1e-5f);
}

class EachMap : public testing::TestWithParam<ToneOperator> {};

TEST_P(EachMap, whatever_a_picture_holds_a_number_from_zero_to_one_leaves) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  auto radiance = halves(1e6f, 0.9f);
  radiance.at(3, 3) = Vec3(nan);
  radiance.at(70, 3) = Vec3(infinity);
  radiance.at(9, 40) = Vec3(0.0f, infinity, nan);
  radiance.at(90, 40) = Vec3(3e38f);
  radiance.at(40, 50) = Vec3(-infinity, -1.0f, 1e-45f);
  for (const float exposure : {-64.0f, 0.0f, 64.0f})
    for (const auto& pixel : tone_map(radiance, {.op = GetParam(), .exposure = exposure}).pixels)
      for (int c = 0; c < 3; ++c) EXPECT_TRUE(pixel[c] >= 0.0f && pixel[c] <= 1.0f) << pixel[c];
}

TEST_P(EachMap, black_stays_black_and_nothing_stays_nothing) {
  EXPECT_TRUE(tone_map(Image(), {.op = GetParam()}).pixels.empty());
  for (const auto& pixel : tone_map(Image(5, 4), {.op = GetParam()}).pixels) EXPECT_EQ(pixel, Vec3(0.0f));
}

TEST_P(EachMap, one_pixel_is_a_picture) {
  const auto pixel = tone_map(Image(1, 1, Vec3(7.0f)), {.op = GetParam()}).at(0, 0);
  const bool is_cut = GetParam() == ToneOperator::maximum || GetParam() == ToneOperator::clamp;
  const bool is_neutral = GetParam() == ToneOperator::neutral;
  EXPECT_NEAR(pixel.g, is_cut ? 1.0f : is_neutral ? 0.5f : 0.18f / 1.18f, 1e-6f);
}

INSTANTIATE_TEST_SUITE_P(Operators, EachMap, testing::ValuesIn(operators), [](const auto& op) {
  return op.param == ToneOperator::reinhard_local ? "local" : std::string(name(op.param));
});

}  // namespace
}  // namespace luxel
