// SPDX-License-Identifier: Apache-2.0
#include "luxel/photometry/sky_patches.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace luxel {
namespace {

constexpr double exact_pi = std::numbers::pi;
const Vec3d up(0.0, 0.0, 1.0), north(0.0, 1.0, 0.0);

Vec3d towards(double elevation, double azimuth) {
  const auto e = elevation * exact_pi / 180.0, a = azimuth * exact_pi / 180.0;
  return {std::cos(e) * std::sin(a), std::cos(e) * std::cos(a), std::sin(e)};
}

TEST(SkyPatches, are_as_many_as_reinhart_has) {
  for (const auto& [subdivision, count] : {std::pair(0, 1), std::pair(1, 145), std::pair(2, 577),
                                           std::pair(3, 1297), std::pair(4, 2305), std::pair(6, 5185)}) {
    const SkyPatches patches(subdivision, up, north);
    EXPECT_EQ(patches.size(), 1u + static_cast<std::size_t>(count));
    EXPECT_EQ(patches.upper(), static_cast<std::size_t>(count));
  }
  EXPECT_EQ(SkyPatches().size(), 1u);
  EXPECT_EQ(SkyPatches(1, up, north, LowerHalf::mirrored).size(), 291u);
}

// gendaymtx: the ground, then the row at the horizon from north to the east; the last is the zenith.
TEST(SkyPatches, stand_in_the_order_of_gendaymtx) {
  const SkyPatches patches(1, up, north);
  EXPECT_EQ(patches.patch_of(towards(-10, 77)), 0u);
  EXPECT_EQ(patches.patch_of(towards(6, 0)), 1u);
  EXPECT_EQ(patches.patch_of(towards(6, 5.9)), 1u);
  EXPECT_EQ(patches.patch_of(towards(6, -5.9)), 1u);
  EXPECT_EQ(patches.patch_of(towards(6, 12)), 2u);
  EXPECT_EQ(patches.patch_of(towards(6, 90)), 9u);
  EXPECT_EQ(patches.patch_of(towards(18, 0)), 31u);
  EXPECT_EQ(patches.patch_of(towards(90, 0)), 145u);
  EXPECT_EQ(patches.patch_of(towards(85, 123)), 145u);
}

class SubdividedSky : public testing::TestWithParam<std::pair<int, LowerHalf>> {};

TEST_P(SubdividedSky, covers_every_direction_once) {
  const auto [subdivision, lower] = GetParam();
  // Any frame: the zenith is -Z and north is +X.
  const SkyPatches patches(subdivision, Vec3d(0.0, 0.0, -1.0), Vec3d(1.0, 0.0, 0.0), lower);
  double whole = 0.0, open_ground = 0.0;
  for (std::size_t p = 0; p < patches.size(); ++p) {
    whole += patches.solid_angle(p);
    if (const auto projected = patches.projected_solid_angle(p); projected > 0.0) open_ground += projected;
    if (!(patches.solid_angle(p) > 0.0)) continue;
    for (const auto& u : {std::array{0.01, 0.01}, std::array{0.5, 0.5}, std::array{0.99, 0.99}}) {
      const auto direction = patches.direction(p, u);
      EXPECT_NEAR(glm::length(direction), 1.0, 1e-12);
      EXPECT_EQ(patches.patch_of(direction), p);
    }
  }
  EXPECT_NEAR(whole, 4.0 * exact_pi, 1e-9);
  EXPECT_NEAR(open_ground, exact_pi, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(all, SubdividedSky,
                         testing::Values(std::pair(0, LowerHalf::one), std::pair(0, LowerHalf::mirrored),
                                         std::pair(1, LowerHalf::one), std::pair(2, LowerHalf::one),
                                         std::pair(4, LowerHalf::mirrored), std::pair(8, LowerHalf::one)));

TEST(SkyPatches, turn_with_north) {
  const SkyPatches patches(2, up, north), turned(2, up, Vec3d(1.0, 0.0, 0.0));
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const auto d = patches.direction(p, {0.3, 0.6});
    EXPECT_EQ(turned.patch_of({d.y, -d.x, d.z}), p);  // turned by 90 degrees, clockwise seen from above
  }
}

}  // namespace
}  // namespace luxel
