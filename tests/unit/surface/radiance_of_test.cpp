// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <numbers>

#include <gtest/gtest.h>

#include "luxel/core/error.h"
#include "luxel/scene/band_colours.h"
#include "luxel/surface/smooth_light.h"

namespace luxel {
namespace {

const BandMaterial lamp = {"lamp", true, {0.5f, 0.25f, 0.0f}, {1.0f, 2.0f, 3.0f}};
const std::array<float, 3> irradiance = {2.0f, 4.0f, 8.0f};

const BandColours plain({});

TEST(RadianceOf, a_front_emits_and_reflects) {
  const auto out = radiance_of(lamp, false, {irradiance.data(), irradiance.data()}, plain);
  EXPECT_FLOAT_EQ(static_cast<float>(out.r), 2.0f * std::numbers::inv_pi_v<float>);
  EXPECT_FLOAT_EQ(static_cast<float>(out.g), 3.0f * std::numbers::inv_pi_v<float>);
  EXPECT_FLOAT_EQ(static_cast<float>(out.b), 3.0f * std::numbers::inv_pi_v<float>);
}

TEST(RadianceOf, a_back_reflects_but_does_not_emit) {
  const auto out = radiance_of(lamp, true, {irradiance.data(), irradiance.data()}, plain);
  EXPECT_FLOAT_EQ(static_cast<float>(out.r), 1.0f * std::numbers::inv_pi_v<float>);
  EXPECT_FLOAT_EQ(static_cast<float>(out.g), 1.0f * std::numbers::inv_pi_v<float>);
  EXPECT_EQ(out.b, 0.0);
}

TEST(RadianceOf, the_back_of_a_one_sided_material_is_black) {
  auto one_sided = lamp;
  one_sided.two_sided = false;
  EXPECT_EQ(radiance_of(one_sided, true, {irradiance.data(), irradiance.data()}, plain), Vec3d(0.0));
}

TEST(RadianceOf, a_diffuser_sends_on_the_light_of_both_sides) {
  auto opal = lamp;
  opal.diffuse_transmittance = {0.25f, 0.25f, 0.5f};
  const std::array<float, 3> behind = {4.0f, 8.0f, 2.0f};
  const auto out = radiance_of(opal, true, {irradiance.data(), behind.data()}, plain);
  EXPECT_FLOAT_EQ(static_cast<float>(out.r), 2.0f * std::numbers::inv_pi_v<float>);
  EXPECT_FLOAT_EQ(static_cast<float>(out.g), 3.0f * std::numbers::inv_pi_v<float>);
  EXPECT_FLOAT_EQ(static_cast<float>(out.b), 1.0f * std::numbers::inv_pi_v<float>);
  // As reflectance times irradiance: albedo times the effective one.
  for (std::size_t b = 0; b < 3; ++b)
    EXPECT_FLOAT_EQ(
        albedo_at(opal, {}, b) * effective_irradiance(opal, {irradiance.data(), behind.data()}, {}, b),
        static_cast<float>(out[static_cast<int>(b)]) * std::numbers::pi_v<float>);
  EXPECT_EQ(effective_irradiance(lamp, {irradiance.data()}, {}, 1), 4.0f);
}

TEST(Colours, red_green_blue_in_this_order_are_colours) {
  const auto with_bands = [](std::vector<std::string> bands) {
    PatchSet patches;
    patches.bands = std::move(bands);
    return patches;
  };
  EXPECT_NO_THROW(with_bands({"red", "green", "blue"}).colours());
  EXPECT_THROW(with_bands({"blue", "green", "red"}).colours(), MismatchError);
  EXPECT_THROW(with_bands({}).colours(), MismatchError);
  try {
    with_bands({"visible", "infrared"}).colours();
    FAIL() << "two bands are not a colour";
  } catch (const MismatchError& error) {
    EXPECT_NE(std::string(error.what()).find("visible, infrared"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace luxel
