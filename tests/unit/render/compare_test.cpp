// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/compare.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "luxel/core/error.h"
#include "luxel/render/difference_picture.h"

#include "support/lit_patches.h"

namespace luxel {
namespace {

// Two triangles of 0.5 and 1 m² with the irradiance of their fronts and backs.
Baked two_patches(float first, float second, float second_back = 0.0f) {
  test::LitPatches lit;
  const auto a = lit.vertex({0, 0, 0});
  const auto b = lit.vertex({1, 0, 0});
  const auto c = lit.vertex({0, 1, 0});
  const auto d = lit.vertex({0, -2, 0});
  lit.patch({a, b, c}, first);
  lit.patch({a, d, b}, second, second_back);
  return {lit.patches, lit.solution};
}

void set_errors(Baked& baked, float error) {
  baked.solution.standard_error.front.assign(6, error);
  baked.solution.standard_error.back.assign(6, 0.0f);
}

TEST(CompareSolutions, weighs_by_area_and_signs_the_bias) {
  const auto c = compare_solutions(two_patches(2.0f, 1.0f), two_patches(2.2f, 0.9f));
  EXPECT_EQ(c.numbers, 12u);
  // Areas 0.5 and 1; differences 0.2 and -0.1.
  EXPECT_NEAR(c.relative_rms, std::sqrt((0.5 * 0.04 + 1.0 * 0.01) / (0.5 * 4.0 + 1.0 * 1.0)), 1e-6);
  EXPECT_NEAR(c.mean_bias, (0.5 * 0.2 - 1.0 * 0.1) / (0.5 * 2.0 + 1.0), 1e-6);
  EXPECT_EQ(c.scored, 0u);
  EXPECT_FALSE(c.agrees().has_value()) << "no errors, no verdict";
  ASSERT_EQ(c.largest.size(), 2u) << "sides that are alike are no difference";
  EXPECT_EQ(c.largest[0].index, 0u);
  EXPECT_EQ(c.largest[1].index, 2u);
  EXPECT_NEAR(c.largest[1].a, 1.0, 1e-6);
  EXPECT_NEAR(c.largest[1].b, 0.9, 1e-6);
}

TEST(CompareSolutions, judges_by_the_errors_of_the_whole_where_one_states_no_others) {
  auto a = two_patches(2.0f, 1.0f);
  set_errors(a, 0.001f);
  a.solution.predicted_error = 0.03;
  auto near = two_patches(2.08f, 0.96f);  // relative RMS 0.040
  EXPECT_FALSE(compare_solutions(a, near).agrees().has_value()) << "the other states no error at all";
  near.solution.predicted_error = 0.04;
  const auto c = compare_solutions(a, near);
  EXPECT_EQ(c.scored, 0u);
  EXPECT_NEAR(c.expected_rms, 0.05, 1e-12);
  EXPECT_TRUE(c.agrees().value());
  auto far = two_patches(2.16f, 0.92f);
  far.solution.predicted_error = 0.04;
  EXPECT_FALSE(compare_solutions(a, far).agrees().value());
}

TEST(CompareSolutions, scores_against_both_error_bars) {
  auto a = two_patches(2.0f, 1.0f);
  auto b = two_patches(2.5f, 1.0f);
  set_errors(a, 0.3f);
  set_errors(b, 0.4f);  // together 0.5
  const auto c = compare_solutions(a, b);
  EXPECT_EQ(c.scored, 6u) << "backs have no error";
  EXPECT_NEAR(c.mean_z2, 0.5, 1e-5) << "z is 1 on one patch, 0 on the other";
  EXPECT_EQ(c.within, 1.0);
  EXPECT_TRUE(c.agrees().value());
  EXPECT_NEAR(c.largest.at(0).error, 0.5, 1e-6);
  EXPECT_NEAR(c.expected_rms, 0.5 * std::sqrt(1.5 / 3.0), 1e-6);
  auto exact = two_patches(4.0f, 1.0f);
  set_errors(exact, 0.0f);
  const auto far = compare_solutions(a, exact);
  EXPECT_FALSE(far.agrees().value());
  EXPECT_EQ(far.outliers, 3u);
  EXPECT_NEAR(far.mean_z2, 18.0, 1e-9) << "six errors off is as much as counts";
}

// Many places, each slightly too bright: no single z-score detects it, the mean does.
TEST(ComparePictures, do_not_agree_where_noise_cannot_explain_the_bias) {
  const Image a(30, 30, Vec3(1.0f));
  const Image error(30, 30, Vec3(0.03f));
  const auto with = [&](float brighter) {
    return compare_pictures(a, Image(30, 30, Vec3(1.0f + brighter)), &error);
  };
  EXPECT_NEAR(with(0.02f).bias_error, 0.03 / 30.0, 1e-6);
  EXPECT_LT(with(0.02f).mean_z2, 1.0);
  EXPECT_FALSE(with(0.02f).agrees().value());
  EXPECT_TRUE(with(0.01f).agrees().value());
}

TEST(CompareSolutions, finds_a_back) {
  const auto c = compare_solutions(two_patches(1, 1, 1), two_patches(1, 1, 2));
  ASSERT_EQ(c.largest.size(), 1u);
  EXPECT_EQ(c.largest[0].index, 3u);
}

TEST(CompareSolutions, of_equal_ones_finds_nothing) {
  const auto c = compare_solutions(two_patches(1, 2), two_patches(1, 2));
  EXPECT_EQ(c.relative_rms, 0.0);
  EXPECT_EQ(c.mean_bias, 0.0);
  EXPECT_TRUE(c.largest.empty());
  const auto dark = compare_solutions(two_patches(0, 0), two_patches(0, 0));
  EXPECT_EQ(dark.relative_rms, 0.0) << "no light, no difference";
}

std::string refusal(const Baked& a, const Baked& b) {
  try {
    compare_solutions(a, b);
  } catch (const MismatchError& error) {
    return error.what();
  }
  return "nothing";
}

TEST(CompareSolutions, refuses_other_meshes_in_a_sentence) {
  auto other = two_patches(1, 1);
  other.patches.vertices[1].x = 1.5f;
  EXPECT_NE(refusal(two_patches(1, 1), other).find("different meshes, though both have 2 patches"),
            std::string::npos);
  test::LitPatches one;
  one.patch({one.vertex({0, 0, 0}), one.vertex({1, 0, 0}), one.vertex({0, 1, 0})}, 1.0f);
  EXPECT_NE(refusal(two_patches(1, 1), {one.patches, one.solution}).find("one of 2 patches and one of 1"),
            std::string::npos);
  auto grey = two_patches(1, 1);
  grey.solution.bands = {"grey", "green", "blue"};
  EXPECT_NE(refusal(two_patches(1, 1), grey).find("different bands"), std::string::npos);
}

TEST(ComparePictures, weighs_pixels_alike_and_takes_pictures_of_errors) {
  const Image a(2, 1, Vec3(1.0f));
  Image b(2, 1, Vec3(1.0f));
  b.at(1, 0) = Vec3(1.3f);
  const Image error(2, 1, Vec3(0.1f));
  const auto c = compare_pictures(a, b, &error);
  EXPECT_NEAR(c.relative_rms, 0.3 / std::sqrt(2.0), 1e-6);
  EXPECT_NEAR(c.mean_bias, 0.15, 1e-6);
  EXPECT_NEAR(c.mean_z2, 4.5, 1e-4);
  EXPECT_NEAR(c.within, 0.5, 1e-9);
  ASSERT_EQ(c.largest.size(), 1u);
  EXPECT_EQ(c.largest[0].index, 1u);
  EXPECT_THROW(compare_pictures(a, Image(1, 2)), MismatchError);
  EXPECT_THROW(compare_pictures(a, b, nullptr, &static_cast<const Image&>(Image(3, 3))), MismatchError);
}

TEST(RelativeDifferences, are_signed_have_a_floor_and_leave_out_what_is_dark_in_both) {
  Image a(3, 1, Vec3(1.0f));
  Image b(3, 1, Vec3(1.1f));
  a.at(1, 0) = Vec3(0.0f);
  b.at(1, 0) = Vec3(0.002f);
  a.at(2, 0) = b.at(2, 0) = Vec3(0.0f);
  const auto fractions = relative_differences(a, b);
  EXPECT_NEAR(fractions[0], 0.1f, 1e-6f);
  EXPECT_NEAR(fractions[1], 0.2f, 1e-6f) << "against a hundredth of the mean of what is lit";
  EXPECT_TRUE(std::isnan(fractions[2]));
}

TEST(DifferencePicture, is_white_without_difference_red_above_blue_below_and_has_a_legend) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  std::vector<float> fractions(120 * 4, 0.0f);
  fractions[0] = 0.1f;
  fractions[1] = -0.1f;
  fractions[2] = nan;
  const auto image = difference_picture(fractions, 120, 4, 0.1f);
  EXPECT_GT(image.height, 20) << "room for the legend";
  EXPECT_EQ(image.at(5, 1), Vec3(1.0f));
  EXPECT_GT(image.at(0, 0).r, 5.0f * image.at(0, 0).b);
  EXPECT_GT(image.at(1, 0).b, 5.0f * image.at(1, 0).r);
  EXPECT_EQ(image.at(2, 0).r, image.at(2, 0).b);
  for (const auto& pixel : image.pixels)
    for (int b = 0; b < 3; ++b) {
      EXPECT_GE(pixel[b], 0.0f);
      EXPECT_LE(pixel[b], 1.0f);
    }
  EXPECT_NO_THROW(difference_picture(std::vector<float>(1, 0.0f), 1, 1, 0.1f)) << "too narrow for any number";
}

TEST(DifferencePicture, has_a_round_scale_that_fits_most) {
  std::vector<float> fractions(100, 0.031f);
  EXPECT_NEAR(automatic_scale(fractions), 0.05f, 1e-6f);
  for (std::size_t i = 0; i < 4; ++i) fractions[i] = 9.0f;
  EXPECT_NEAR(automatic_scale(fractions), 0.05f, 1e-6f);
  EXPECT_NEAR(automatic_scale(std::vector<float>(3, -0.2f)), 0.2f, 1e-6f);
  EXPECT_GT(automatic_scale(std::vector<float>(3, 0.0f)), 0.0f);
  EXPECT_EQ(automatic_scale({}), 0.01f);
}

}  // namespace
}  // namespace luxel
