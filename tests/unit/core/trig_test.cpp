// SPDX-License-Identifier: Apache-2.0
#include "luxel/core/trig.h"

#include <gtest/gtest.h>

namespace luxel {
namespace {

TEST(Trig, sine_and_cosine_agree_with_the_library_to_1e_13) {
  for (int i = -200'000; i <= 200'000; ++i) {
    const double x = 1e-4 * i;
    const auto [s, c] = sin_cos(x);
    ASSERT_NEAR(s, std::sin(x), 1e-13) << x;
    ASSERT_NEAR(c, std::cos(x), 1e-13) << x;
  }
}

TEST(Trig, sine_and_cosine_hold_for_large_and_small_angles) {
  for (const double x : {1e6, -1e6, 123456.789, 54321.0, 1e3}) {
    EXPECT_NEAR(sin_cos(x).sine, std::sin(x), 1e-10);
    EXPECT_NEAR(sin_cos(x).cosine, std::cos(x), 1e-10);
  }
  for (const double x : {1e-300, 1e-20, 1e-8}) {
    EXPECT_EQ(sin_cos(x).sine, x);
    EXPECT_EQ(sin_cos(x).cosine, 1.0);
  }
}

TEST(Trig, the_angle_of_a_point_agrees_with_the_library_in_every_direction) {
  for (int i = -100'000; i <= 100'000; ++i) {
    const double angle = i * (std::numbers::pi / 100'000);
    for (const double radius : {1e-200, 1e-3, 1.0, 1e200}) {
      const double y = radius * std::sin(angle);
      const double x = radius * std::cos(angle);
      const double expected = std::atan2(y, x);
      ASSERT_NEAR(arc_tangent(y, x), expected, 4e-15 * std::fabs(expected)) << angle;
    }
  }
}

TEST(Trig, the_angle_is_exact_on_the_axes_and_zero_at_the_origin) {
  EXPECT_EQ(arc_tangent(0.0, 0.0), 0.0);
  EXPECT_EQ(arc_tangent(0.0, 2.0), 0.0);
  EXPECT_EQ(arc_tangent(2.0, 0.0), std::numbers::pi / 2.0);
  EXPECT_EQ(arc_tangent(-2.0, 0.0), -std::numbers::pi / 2.0);
  EXPECT_EQ(arc_tangent(0.0, -2.0), std::numbers::pi);
}

TEST(Trig, a_small_angle_keeps_its_relative_accuracy) {
  for (double y = 1e-300; y < 1e-2; y *= 10.0)
    EXPECT_NEAR(arc_tangent(y, 1.0), std::atan2(y, 1.0), 4e-15 * y);
}

TEST(Trig, the_angle_of_a_cosine_agrees_with_the_library) {
  for (int i = -10'000; i <= 10'000; ++i) {
    const double expected = std::acos(1e-4 * i);
    ASSERT_NEAR(arc_cosine(1e-4 * i), expected, 4e-15 * expected + 1e-15);
  }
  EXPECT_EQ(arc_cosine(1.5), 0.0);
  EXPECT_EQ(arc_cosine(-1.5), std::numbers::pi);
}

}  // namespace
}  // namespace luxel
