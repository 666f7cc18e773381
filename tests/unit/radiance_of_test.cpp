// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <numbers>

#include <gtest/gtest.h>

#include "luxel/report/error.h"
#include "luxel/surface/smooth_light.h"

namespace luxel {
namespace {

const BandMaterial lamp = {"lamp", true, {0.5f, 0.25f, 0.0f}, {1.0f, 2.0f, 3.0f}};
const std::array<float, 3> irradiance = {2.0f, 4.0f, 8.0f};

TEST(RadianceOf, a_front_emits_and_reflects) {
  std::array<float, 3> out{};
  radiance_of(lamp, false, irradiance.data(), out.data());
  EXPECT_FLOAT_EQ(out[0], 2.0f * std::numbers::inv_pi_v<float>);
  EXPECT_FLOAT_EQ(out[1], 3.0f * std::numbers::inv_pi_v<float>);
  EXPECT_FLOAT_EQ(out[2], 3.0f * std::numbers::inv_pi_v<float>);
}

TEST(RadianceOf, a_back_reflects_but_does_not_emit) {
  std::array<float, 3> out{};
  radiance_of(lamp, true, irradiance.data(), out.data());
  EXPECT_FLOAT_EQ(out[0], 1.0f * std::numbers::inv_pi_v<float>);
  EXPECT_FLOAT_EQ(out[1], 1.0f * std::numbers::inv_pi_v<float>);
  EXPECT_EQ(out[2], 0.0f);
}

TEST(RadianceOf, the_back_of_a_one_sided_material_is_black) {
  auto one_sided = lamp;
  one_sided.two_sided = false;
  std::array<float, 3> out = {9.0f, 9.0f, 9.0f};
  radiance_of(one_sided, true, irradiance.data(), out.data());
  EXPECT_EQ(out, (std::array<float, 3>{0.0f, 0.0f, 0.0f}));
}

TEST(CheckRgb, red_green_blue_in_this_order_is_colour) {
  EXPECT_NO_THROW(check_rgb({"red", "green", "blue"}));
  EXPECT_THROW(check_rgb({"blue", "green", "red"}), MismatchError);
  EXPECT_THROW(check_rgb({}), MismatchError);
  try {
    check_rgb({"visible", "infrared"});
    FAIL() << "two bands are not a colour";
  } catch (const MismatchError& error) {
    EXPECT_NE(std::string(error.what()).find("visible, infrared"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace luxel
