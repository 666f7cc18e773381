// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "luxel/core/error.h"
#include "luxel/image/tone.h"

namespace luxel {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr ToneOperator operators[] = {ToneOperator::neutral, ToneOperator::maximum, ToneOperator::clamp,
                                      ToneOperator::reinhard, ToneOperator::reinhard_local};

const ToneOptions reinhard{.op = ToneOperator::reinhard};

void expect_near(const Vec3& a, const Vec3& b, float tolerance = 1e-6f) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], tolerance) << "channel " << c;
}

ToneCurve fit(std::vector<Vec3> radiance, std::vector<float> weights, const ToneOptions& options = {}) {
  return fit_curve(radiance, weights, options);
}

TEST(ToneOperator, each_name_gives_its_operator_back) {
  for (const auto op : operators) EXPECT_EQ(tone_operator(name(op)), op);
  EXPECT_EQ(name(ToneOperator::reinhard_local), "reinhard-local");
  EXPECT_EQ(tone_operator("reinhart"), std::nullopt);
  EXPECT_EQ(tone_operator(""), std::nullopt);
}

TEST(Reinhard, one_grey_becomes_key_over_one_plus_key_whatever_its_radiance) {
  for (const float radiance : {1e-6f, 0.3f, 5000.0f})
    for (const float key : {0.18f, 0.72f})
      expect_near(fit({Vec3(radiance)}, {2.0f}, {.op = ToneOperator::reinhard, .key = key})(Vec3(radiance)),
                  Vec3(key / (1.0f + key)));
}

TEST(Reinhard, the_log_average_is_over_area) {
  // exp((3 log 1 + 1 log 16) / 4) = 16^(1/4) = 2.
  const auto curve = fit({Vec3(1.0f), Vec3(16.0f)}, {3.0f, 1.0f}, reinhard);
  EXPECT_NEAR(curve.scale, 0.18f / 2.0f, 1e-7f);
}

TEST(Reinhard, splitting_a_patch_in_two_changes_nothing) {
  const auto whole = fit({Vec3(1.0f), Vec3(50.0f)}, {8.0f, 1.0f}, reinhard);
  const auto split = fit({Vec3(1.0f), Vec3(50.0f), Vec3(1.0f)}, {3.0f, 1.0f, 5.0f}, reinhard);
  EXPECT_FLOAT_EQ(whole.scale, split.scale);
}

TEST(Reinhard, what_has_no_light_no_area_or_no_number_is_left_out_of_the_average) {
  const auto plain = fit({Vec3(2.0f)}, {1.0f}, reinhard);
  const auto mixed = fit({Vec3(0.0f), Vec3(2.0f), Vec3(nan), Vec3(infinity), Vec3(9.0f), Vec3(7.0f)},
                         {100.0f, 1.0f, 1.0f, 1.0f, 0.0f, nan}, reinhard);
  EXPECT_EQ(plain.scale, mixed.scale);
}

TEST(Reinhard, white_is_the_smallest_luminance_shown_as_white) {
  // Equation 4 at L = white: L (1 + 1) / (1 + L) would be 1 for L = 1; in general L_d(white) = 1.
  const auto curve = fit({Vec3(1.0f)}, {1.0f}, {.op = ToneOperator::reinhard, .key = 1.0f, .white = 4.0f});
  expect_near(curve(Vec3(4.0f)), Vec3(1.0f));
  EXPECT_LT(curve(Vec3(3.9f)).g, 0.999f);
  expect_near(curve(Vec3(2.0f)), Vec3(2.0f * (1.0f + 2.0f / 16.0f) / 3.0f));
}

TEST(Reinhard, a_stop_of_exposure_doubles_what_enters_the_curve) {
  const auto curve = fit({Vec3(1.0f)}, {1.0f}, {.op = ToneOperator::reinhard, .exposure = 1.0f});
  expect_near(curve(Vec3(1.0f)), Vec3(0.36f / 1.36f));
}

TEST(Reinhard, a_color_keeps_its_hue) {
  const auto curve = fit({Vec3(1.0f)}, {1.0f}, reinhard);
  const auto shown = curve(Vec3(0.8f, 0.4f, 0.2f));
  EXPECT_NEAR(shown.r / shown.g, 2.0f, 1e-6f);
  EXPECT_NEAR(shown.g / shown.b, 2.0f, 1e-6f);
  const float L = 0.18f * luminance(Vec3(0.8f, 0.4f, 0.2f));
  EXPECT_NEAR(luminance(shown), L / (1.0f + L), 1e-6f);
}

// 0.6 over the 90th percentile, but the log-average between 0.25 and 0.5.
TEST(Neutral, the_bright_part_decides_the_exposure) {
  EXPECT_FLOAT_EQ(fit({Vec3(4.0f)}, {1.0f}).scale, 0.5f / 4.0f) << "a white room";
  EXPECT_FLOAT_EQ(fit({Vec3(1.0f), Vec3(2.0f)}, {1.0f, 1.0f}).scale, 0.6f / 2.0f);
  EXPECT_FLOAT_EQ(fit({Vec3(1.0f), Vec3(2.0f), Vec3(50.0f)}, {50.0f, 50.0f, 1.0f}).scale, 0.6f / 2.0f)
      << "a small lamp";
  const auto average = std::pow(100.0f, 0.25f);  // over area
  EXPECT_FLOAT_EQ(fit({Vec3(1.0f), Vec3(100.0f)}, {3.0f, 1.0f}).scale, 0.25f / average) << "a bright window";
  EXPECT_FLOAT_EQ(fit({Vec3(4.0f), Vec3(0.03f)}, {1.0f, 1.0f}).scale, 0.5f / 4.0f) << "half of it unlit";
  EXPECT_FLOAT_EQ(fit({Vec3(4.0f)}, {1.0f}, {.key = 0.3f}).scale, 0.3f / 4.0f);
  EXPECT_FLOAT_EQ(fit({Vec3(4.0f)}, {1.0f}, {.exposure = -1.0f}).scale, 0.25f / 4.0f);
}

TEST(Neutral, keeps_colours_below_0_76_and_brings_brighter_ones_to_white) {
  const ToneCurve curve{.options = {.op = ToneOperator::neutral}};
  expect_near(curve(Vec3(0.76f, 0.1f, 0.3f)), Vec3(0.76f, 0.1f, 0.3f));
  // The specification at a peak of 1: 1 - 0.24² / (1 + 0.24 - 0.76) = 0.88; then 0.01768 of the way to white.
  const auto to_white = 1.0f - 1.0f / (0.15f * 0.12f + 1.0f);
  expect_near(curve(Vec3(1.0f, 0.5f, 0.0f)), Vec3(0.88f, 0.44f + to_white * 0.44f, to_white * 0.88f), 1e-6f);
  const auto bright = curve(Vec3(1000.0f, 0.0f, 0.0f));
  EXPECT_GT(bright.g, 0.98f) << "a very bright red is white";
}

TEST(Maximum, the_largest_channel_becomes_one) {
  const auto curve = fit({Vec3(0.5f, 2.0f, 8.0f), Vec3(4.0f)}, {1.0f, 1.0f}, {.op = ToneOperator::maximum});
  expect_near(curve(Vec3(0.5f, 2.0f, 8.0f)), Vec3(0.0625f, 0.25f, 1.0f));
  expect_near(curve(Vec3(4.0f)), Vec3(0.5f));
}

TEST(Maximum, exposure_comes_after_it) {
  const auto curve = fit({Vec3(4.0f)}, {1.0f}, {.op = ToneOperator::maximum, .exposure = -1.0f});
  expect_near(curve(Vec3(4.0f)), Vec3(0.5f));
}

TEST(Clamp, values_below_one_stay_and_those_above_are_cut) {
  const auto curve = fit({Vec3(9.0f)}, {1.0f}, {.op = ToneOperator::clamp});
  expect_near(curve(Vec3(0.1f, 0.9f, 3.0f)), Vec3(0.1f, 0.9f, 1.0f));
}

class EachCurve : public testing::TestWithParam<ToneOperator> {};

TEST_P(EachCurve, more_light_is_never_darker) {
  const auto curve = fit({Vec3(0.01f), Vec3(1.0f), Vec3(100.0f)}, {1.0f, 1.0f, 1.0f}, {.op = GetParam()});
  float before = -1.0f;
  for (float v = 0.0f; v < 1000.0f; v = 1.1f * v + 1e-6f) {
    const float shown = curve(Vec3(v)).g;
    EXPECT_GE(shown, before) << v;
    before = shown;
  }
}

TEST_P(EachCurve, nothing_or_black_gives_scale_one_and_black) {
  for (const auto& curve : {fit({}, {}, {.op = GetParam()}), fit({Vec3(0.0f)}, {1.0f}, {.op = GetParam()})}) {
    EXPECT_EQ(curve.scale, 1.0f);
    EXPECT_EQ(curve(Vec3(0.0f)), Vec3(0.0f));
  }
}

TEST_P(EachCurve, whatever_enters_a_number_from_zero_to_one_leaves) {
  const std::vector<Vec3> colors = {Vec3(0.0f),
                                    Vec3(1e-45f),
                                    Vec3(1e-38f),
                                    Vec3(1.0f),
                                    Vec3(3e38f),
                                    Vec3(infinity),
                                    Vec3(nan, 1.0f, 0.0f),
                                    Vec3(-infinity),
                                    Vec3(-1.0f),
                                    Vec3(nan),
                                    Vec3(0.0f, infinity, 1.0f)};
  for (const auto& fitted_to : colors)
    for (const float exposure : {-64.0f, 0.0f, 64.0f})
      for (const float white : {0.0f, 1e-30f, 1e30f}) {
        const auto curve = fit({fitted_to}, {1.0f}, {.op = GetParam(), .exposure = exposure, .white = white});
        EXPECT_TRUE(std::isfinite(curve.scale));
        for (const auto& color : colors)
          for (int c = 0; c < 3; ++c) {
            const float shown = curve(color)[c];
            EXPECT_TRUE(shown >= 0.0f && shown <= 1.0f) << shown;
          }
      }
}

TEST_P(EachCurve, a_given_scale_is_taken_and_the_exposure_comes_on_top) {
  const auto curve =
      fit({Vec3(0.01f), Vec3(7.0f)}, {1.0f, 1.0f}, {.op = GetParam(), .exposure = 1.0f, .scale = 0.1f});
  EXPECT_FLOAT_EQ(curve.scale, 0.2f);
}

TEST_P(EachCurve, options_out_of_range_are_refused) {
  for (const ToneOptions& wrong :
       {ToneOptions{.op = GetParam(), .exposure = nan}, ToneOptions{.op = GetParam(), .exposure = 65.0f},
        ToneOptions{.op = GetParam(), .key = -0.1f}, ToneOptions{.op = GetParam(), .key = 1.5f},
        ToneOptions{.op = GetParam(), .scale = 0.0f}, ToneOptions{.op = GetParam(), .white = -1.0f},
        ToneOptions{.op = GetParam(), .white = infinity}})
    EXPECT_THROW(fit({Vec3(1.0f)}, {1.0f}, wrong), InputError);
}

INSTANTIATE_TEST_SUITE_P(Operators, EachCurve, testing::ValuesIn(operators), [](const auto& op) {
  return op.param == ToneOperator::reinhard_local ? "local" : std::string(name(op.param));
});

}  // namespace
}  // namespace luxel
