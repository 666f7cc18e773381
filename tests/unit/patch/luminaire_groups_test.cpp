// SPDX-License-Identifier: Apache-2.0
#include "luxel/patch/luminaire_groups.h"

#include <array>
#include <memory>

#include <gtest/gtest.h>

namespace luxel {
namespace {

// A luminaire of the same intensity everywhere, in W/sr by linear sRGB.
BandPointLight luminaire(const std::vector<float>& rgb, std::uint32_t group) {
  auto photometry = std::make_shared<Photometry>();
  photometry->intensity = {GoniometerType::c, {0.0, 180.0}, {0.0}, {100.0, 100.0}};
  BandPointLight lamp;
  lamp.light.kind = PointLightKind::luminaire;
  lamp.light.photometry = photometry;
  lamp.intensity = rgb;
  lamp.light_group = group;
  return lamp;
}

PatchSet lit_by(const std::vector<BandPointLight>& lamps) {
  PatchSet patches;
  patches.bands = {"red", "green", "blue"};
  patches.light_groups = {"one", "two"};
  patches.point_lights = lamps;
  return patches;
}

constexpr std::array tint = {1.0f, 0.2f, 0.0f};

TEST(RelativeLumens, of_white_luminaires_is_the_luminance_of_the_tint) {
  const auto patches = lit_by({luminaire({2.0f, 2.0f, 2.0f}, 0), luminaire({1.0f, 1.0f, 1.0f}, 0)});
  EXPECT_TRUE(has_luminaires(patches));
  EXPECT_NEAR(relative_lumens(patches, 0, tint), 0.2126 + 0.2 * 0.7152, 1e-6);
  EXPECT_NEAR(relative_lumens(patches, 0, std::array{0.5f, 0.5f, 0.5f}), 0.5, 1e-6);
}

TEST(RelativeLumens, counts_each_luminaire_by_its_own_colour_and_flux) {
  const auto patches = lit_by({luminaire({3.0f, 0.0f, 0.0f}, 0), luminaire({0.0f, 1.0f, 0.0f}, 0)});
  const auto own = 3.0 * 0.2126 + 0.7152, tinted = 3.0 * 0.2126 + 0.2 * 0.7152;
  EXPECT_NEAR(relative_lumens(patches, 0, tint), tinted / own, 1e-6);
}

TEST(RelativeLumens, is_one_without_luminaires_that_give_light) {
  auto patches = lit_by({luminaire({1.0f, 1.0f, 1.0f}, 0), luminaire({0.0f, 0.0f, 0.0f}, 1)});
  EXPECT_EQ(relative_lumens(patches, 1, tint), 1.0);
  patches.point_lights[0].light.kind = PointLightKind::point;
  patches.point_lights.pop_back();
  EXPECT_FALSE(has_luminaires(patches));
  EXPECT_EQ(relative_lumens(patches, 0, tint), 1.0);
}

}  // namespace
}  // namespace luxel
