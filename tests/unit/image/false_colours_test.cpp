// SPDX-License-Identifier: Apache-2.0
#include "luxel/image/false_colours.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace luxel {
namespace {

TEST(FalseColours, scales_end_at_round_numbers) {
  EXPECT_EQ(automatic_scale({0.0, 730.0, 690.0}, "lx").high, 1000.0);
  EXPECT_EQ(automatic_scale({500.0}, "lx").high, 500.0);
  EXPECT_EQ(automatic_scale({0.013}, "lx").high, 0.02);
  EXPECT_EQ(automatic_scale({0.0}, "lx").high, 1.0);
}

TEST(FalseColours, grow_lighter_with_the_value_and_stay_at_the_ends) {
  const FalseColourScale scale{100.0, "lx"};
  std::vector<double> values;
  for (int i = 0; i <= 10; ++i) values.push_back(10.0 * i);
  const auto image = false_colours(values, 11, 1, scale);
  for (int i = 1; i <= 10; ++i) EXPECT_GT(luminance(image.at(i, 0)), luminance(image.at(i - 1, 0))) << i;
  const auto ends = false_colours({-5.0, 1e9, std::numeric_limits<double>::quiet_NaN()}, 3, 1, scale);
  EXPECT_EQ(ends.at(0, 0), image.at(0, 0));
  EXPECT_EQ(ends.at(1, 0), image.at(10, 0));
  EXPECT_EQ(ends.at(2, 0), Vec3(0.2f));
}

TEST(FalseColours, large_pictures_have_a_legend_at_the_right) {
  const std::vector<double> values(240 * 180, 0.0);
  const auto image = false_colours(values, 240, 180, {500.0, "cd/m2"});
  EXPECT_EQ(image.at(239, 0), Vec3(1.0f));
  EXPECT_EQ(image.at(100, 90), false_colours({0.0}, 1, 1, {500.0, "lx"}).at(0, 0));
  // The bar runs from the last colour to the first.
  int lighter = 0;
  for (int x = 170; x < 240; ++x)
    if (luminance(image.at(x, 40)) < 0.99f && luminance(image.at(x, 40)) > luminance(image.at(x, 160)))
      ++lighter;
  EXPECT_GE(lighter, 8);
}

}  // namespace
}  // namespace luxel
