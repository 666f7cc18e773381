// SPDX-License-Identifier: Apache-2.0
// The relative error that 95 % of the lit sides stay below.
#include "luxel/solution/error_95th.h"

#include <gtest/gtest.h>

namespace luxel {
namespace {

// Fronts of 1,000 patches with relative errors of 0.1 % to 100 % in one band; backs are dark.
Solution ramp() {
  Solution s;
  s.bands = {"grey"};
  for (int i = 1; i <= 1000; ++i) {
    s.irradiance.front.push_back(2.0f);
    s.standard_error.front.push_back(2.0f * 1e-3f * static_cast<float>(i));
  }
  s.irradiance.back.assign(1000, 0.0f);
  s.standard_error.back.assign(1000, 0.0f);
  return s;
}

TEST(Error95th, is_the_percentile_over_lit_sides) { EXPECT_NEAR(error_95th_of(ramp()), 0.95, 1e-3); }

TEST(Error95th, leaks_of_light_do_not_count) {
  auto s = ramp();
  s.irradiance.back.assign(1000, 1e-9f);
  s.standard_error.back.assign(1000, 0.1f);
  EXPECT_NEAR(error_95th_of(s), 0.95, 1e-3);
}

TEST(Error95th, takes_the_root_mean_square_over_bands) {
  Solution s;
  s.bands = {"red", "green"};
  s.irradiance.front = {3.0f, 4.0f};
  s.irradiance.back = {0.0f, 0.0f};
  s.standard_error.front = {0.6f, 0.8f};
  s.standard_error.back = {0.0f, 0.0f};
  EXPECT_NEAR(error_95th_of(s), 0.2, 1e-6);
}

TEST(Error95th, of_the_dark_or_of_no_standard_errors_is_0) {
  auto dark = ramp();
  dark.irradiance.front.assign(1000, 0.0f);
  EXPECT_EQ(error_95th_of(dark), 0.0);
  auto exact = ramp();
  exact.standard_error.front.clear();
  exact.standard_error.back.clear();
  EXPECT_EQ(error_95th_of(exact), 0.0);
}

}  // namespace
}  // namespace luxel
