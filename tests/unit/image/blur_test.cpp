// SPDX-License-Identifier: Apache-2.0
#include "luxel/image/blur.h"

#include <cmath>
#include <numbers>
#include <numeric>

#include <gtest/gtest.h>

namespace luxel {
namespace {

GreyPicture plane(int width, int height, float fill = 0.0f) {
  return {width, height, std::vector<float>(static_cast<std::size_t>(width * height), fill)};
}

TEST(Blur, a_constant_stays_what_it_is_up_to_the_edges) {
  for (const float sigma : {0.25f, 2.0f, 50.0f})
    for (const float v : gaussian_blur(plane(31, 7, 3.5f), sigma).values) EXPECT_NEAR(v, 3.5f, 1e-5f);
}

TEST(Blur, far_from_edges_a_point_becomes_the_gaussian) {
  auto point = plane(61, 61);
  point.values[30 * 61 + 30] = 1.0f;
  const float sigma = 4.0f;
  const auto blurred = gaussian_blur(point, sigma);
  const double peak = 1.0 / (2.0 * std::numbers::pi * sigma * sigma);
  for (int y = 0; y < 61; ++y)
    for (int x = 0; x < 61; ++x) {
      const double r2 = (x - 30) * (x - 30) + (y - 30) * (y - 30);
      // The cut at 3 sigma leaves out 0.27 % of the weight a line.
      EXPECT_NEAR(blurred.values[y * 61 + x], peak * std::exp(-0.5 * r2 / (sigma * sigma)), 0.012 * peak);
    }
  EXPECT_NEAR(std::accumulate(blurred.values.begin(), blurred.values.end(), 0.0), 1.0, 1e-5);
}

TEST(Blur, a_straight_ramp_stays_straight_in_the_middle) {
  auto ramp = plane(40, 3);
  for (int i = 0; i < 120; ++i) ramp.values[i] = static_cast<float>(i % 40);
  const auto blurred = gaussian_blur(ramp, 3.0f);
  for (int x = 9; x < 31; ++x) EXPECT_NEAR(blurred.values[40 + x], static_cast<float>(x), 1e-4f);
}

TEST(Blur, one_pixel_and_none_are_planes) {
  EXPECT_FLOAT_EQ(gaussian_blur(plane(1, 1, 2.0f), 10.0f).values[0], 2.0f);
  EXPECT_TRUE(gaussian_blur(plane(0, 0), 1.0f).values.empty());
}

}  // namespace
}  // namespace luxel
