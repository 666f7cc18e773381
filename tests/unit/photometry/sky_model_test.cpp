// SPDX-License-Identifier: Apache-2.0
// The CIE's skies against closed forms, published ratios and independent integrals.
#include "luxel/photometry/sky_model.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include <gtest/gtest.h>

#include "luxel/core/error.h"
#include "luxel/photometry/sky_integrals.h"
#include "luxel/photometry/sun_position.h"

namespace luxel {
namespace {

constexpr double exact_pi = std::numbers::pi;
const Vec3d zenith(0.0, 0.0, 1.0), north(0.0, 1.0, 0.0);

SkyModel sky(int type, double elevation, double azimuth = 180.0) {
  return SkyModel::cie(type, direction_towards(elevation, azimuth));
}

TEST(SkyModel, has_unit_luminance_at_the_zenith) {
  for (int type = 1; type <= sky_types; ++type)
    for (const double elevation : {0.0, 30.0, 60.0, 90.0})
      EXPECT_NEAR(sky(type, elevation).relative_luminance(zenith), 1.0, 1e-12) << type;
  EXPECT_EQ(SkyModel().relative_luminance(zenith), 1.0);
}

struct Ratio {
  int type;
  double at_60, at_30;  // illuminance of the ground over the zenith's luminance, by elevation of the sun
};

// Integrated by another program to the digits given here.
constexpr Ratio ratios[] = {{1, 2.44954, 2.44954},  {2, 2.08602, 2.55658},  {3, 2.76999, 2.76999},
                            {4, 2.31542, 2.89015},  {5, 3.14159, 3.14159},  {6, 2.58416, 3.27783},
                            {8, 2.32838, 4.12308},  {9, 3.45932, 4.55275},  {10, 3.17026, 5.14491},
                            {11, 2.98906, 5.81763}, {12, 3.19057, 6.39411}, {14, 3.21696, 7.70810},
                            {15, 3.01586, 8.11602}};

TEST(SkyModel, has_the_known_ratio_of_illuminance_and_zenith_luminance) {
  constexpr double last_digit = 0.0000051;
  for (const auto& ratio : ratios) {
    EXPECT_NEAR(relative_illuminances(sky(ratio.type, 60.0)).horizontal, ratio.at_60, last_digit)
        << ratio.type;
    EXPECT_NEAR(relative_illuminances(sky(ratio.type, 30.0)).horizontal, ratio.at_30, last_digit)
        << ratio.type;
  }
  EXPECT_NEAR(relative_illuminances(sky(16, 30.0)).horizontal, 7.0 * exact_pi / 9.0, 1e-9);
  EXPECT_NEAR(relative_illuminances(SkyModel()).horizontal, exact_pi, 1e-9);
}

// Vertical planes under the overcast sky: 1/2 of the uniform part, and 4/3 of sine and cosine.
TEST(SkyModel, has_closed_forms_on_vertical_planes) {
  const auto uniform = relative_illuminances(SkyModel());
  const auto overcast = relative_illuminances(SkyModel::cie(16));
  const auto truth = (exact_pi / 2.0 + 4.0 / 3.0) / 3.0;
  for (const auto side :
       {&SkyIlluminances::north, &SkyIlluminances::east, &SkyIlluminances::south, &SkyIlluminances::west}) {
    EXPECT_NEAR(uniform.*side, exact_pi / 2.0, 1e-9);
    EXPECT_NEAR(overcast.*side, truth, 1e-9);
    EXPECT_NEAR(overcast.*side / overcast.horizontal, 3.0 / 14.0 + 4.0 / (7.0 * exact_pi), 1e-8);
  }
}

// A plain sum over small cells of equal solid angle, of another shape than those of the quadrature.
TEST(SkyModel, has_the_illuminances_of_a_plain_sum) {
  constexpr int heights = 1000, turns = 2000;
  for (const int type : {4, 7, 12, 13, 15}) {
    const auto model = sky(type, 40.0, 110.0);
    SkyIlluminances sum;
    for (int i = 0; i < heights; ++i)
      for (int j = 0; j < turns; ++j) {
        const auto height = (i + 0.5) / heights, azimuth = 2.0 * exact_pi * (j + 0.5) / turns;
        const auto level = std::sqrt(1.0 - height * height);
        const Vec3d d(level * std::sin(azimuth), level * std::cos(azimuth), height);
        const auto light = 2.0 * exact_pi / heights / turns * model.relative_luminance(d);
        sum.horizontal += light * d.z;
        sum.north += light * std::max(0.0, d.y);
        sum.east += light * std::max(0.0, d.x);
        sum.south += light * std::max(0.0, -d.y);
        sum.west += light * std::max(0.0, -d.x);
      }
    const auto exact = relative_illuminances(model);
    for (const auto part : {&SkyIlluminances::horizontal, &SkyIlluminances::north, &SkyIlluminances::east,
                            &SkyIlluminances::south, &SkyIlluminances::west})
      EXPECT_NEAR(exact.*part / (sum.*part), 1.0, 2e-5) << type;
  }
}

TEST(SkyModel, turns_with_the_sun) {
  const auto south = relative_illuminances(sky(12, 30.0, 180.0));
  const auto east = relative_illuminances(sky(12, 30.0, 90.0));
  const auto between = relative_illuminances(sky(12, 30.0, 77.0));
  EXPECT_NEAR(south.south, east.east, 1e-6 * south.south);
  EXPECT_NEAR(south.west, east.south, 1e-6 * south.west);
  EXPECT_NEAR(south.west, south.east, 1e-6 * south.west);
  EXPECT_GT(south.south, 2.0 * south.north);
  EXPECT_NEAR(south.horizontal, between.horizontal, 1e-6 * south.horizontal);
  for (const int type : {1, 3, 5, 16}) EXPECT_FALSE(sky(type, 30.0).follows_sun());
  for (const int type : {2, 4, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15})
    EXPECT_TRUE(sky(type, 30.0).follows_sun());
}

TEST(SkyModel, is_dark_below_the_horizon_and_finite_on_it) {
  for (int type = 1; type <= sky_types; ++type) {
    const auto model = sky(type, 10.0);
    EXPECT_EQ(model.relative_luminance({0.6, 0.0, -0.8}), 0.0);
    EXPECT_GT(model.relative_luminance(north), 0.0);
    EXPECT_NEAR(model.relative_luminance(north), model.relative_luminance(direction_towards(1e-9, 0.0)),
                1e-6);
  }
  // b above 0 has no limit at the horizon.
  const auto model = SkyModel::perez({-0.5, 0.3, 2.0, -1.0, 0.0}, direction_towards(30.0, 0.0));
  EXPECT_TRUE(std::isfinite(model.relative_luminance(north)));
}

TEST(SkyModel, has_a_sun_below_the_horizon_on_it) {
  const auto below = sky(12, -5.0, 200.0), on = sky(12, 0.0, 200.0);
  const auto d = direction_towards(20.0, 190.0);
  EXPECT_NEAR(below.relative_luminance(d), on.relative_luminance(d), 1e-12);
  EXPECT_THROW(SkyModel::cie(0), InputError);
  EXPECT_THROW(SkyModel::cie(17), InputError);
}

class PatchedSky : public testing::TestWithParam<int> {};

TEST_P(PatchedSky, has_the_exact_mean_of_every_patch_and_the_energy) {
  const SkyPatches patches(GetParam(), Vec3d(0.0, 1.0, 0.0), Vec3d(0.0, 0.0, -1.0));
  const auto model = sky(13, 60.0, 33.0);
  const auto luminances = sky_patch_luminances(model, patches, {12345.0, 50000.0, 0.3});
  ASSERT_EQ(luminances.size(), patches.size());
  double illuminance = 0.0;
  for (std::size_t p = 1; p < patches.size(); ++p)
    illuminance += luminances[p] * patches.projected_solid_angle(p);
  EXPECT_NEAR(illuminance, 12345.0, 1e-7);
  EXPECT_NEAR(luminances[0], 0.3 * 62345.0 / exact_pi, 1e-9);
  // The mean by a plain sum; all patches share one factor, which is near that of the whole sky.
  constexpr int steps = 100;
  const auto whole = 12345.0 / relative_illuminances(model).horizontal;
  double lowest = 1e9, highest = 0.0;
  for (std::size_t p = 1; p < patches.size(); p += patches.size() / 70) {
    double sum = 0.0;
    for (int i = 0; i < steps; ++i)
      for (int j = 0; j < steps; ++j)
        sum += model.relative_luminance(
            patches.in_local_axes(patches.direction(p, {(i + 0.5) / steps, (j + 0.5) / steps})));
    const auto factor = luminances[p] / (sum / (steps * steps));
    lowest = std::min(lowest, factor);
    highest = std::max(highest, factor);
  }
  EXPECT_NEAR(highest / lowest, 1.0, 2e-4);
  EXPECT_NEAR(lowest / whole, 1.0, 0.01);  // the patches' illuminance differs by less than 1 %
}

INSTANTIATE_TEST_SUITE_P(all, PatchedSky, testing::Values(1, 2, 4));

TEST(SkyPatchLuminances, are_those_of_the_ground_below_the_horizon) {
  const SkyPatches patches(2, zenith, north, LowerHalf::mirrored);
  const auto luminances = sky_patch_luminances(SkyModel(), patches, 10000.0, 0.2);
  for (std::size_t p = 1; p < patches.size(); ++p)
    EXPECT_NEAR(luminances[p], (p <= patches.upper() ? 1.0 : 0.2) * 10000.0 / exact_pi, 1e-8);
  EXPECT_THROW(sky_patch_luminances(SkyModel(), SkyPatches(), 1.0, 0.2), InputError);
}

// Patches turn with north: the sky over a scene whose north is +X.
TEST(SkyPatchLuminances, follow_north) {
  const SkyPatches plain(2, zenith, north), turned(2, zenith, Vec3d(1.0, 0.0, 0.0));
  const auto a = sky_patch_luminances(sky(12, 30.0, 70.0), plain, 10000.0, 0.2);
  const auto b = sky_patch_luminances(sky(12, 30.0, 70.0), turned, 10000.0, 0.2);
  for (std::size_t p = 0; p < a.size(); ++p) EXPECT_NEAR(a[p], b[p], 1e-9 * a[p]);
}

// A window in the plane one metre in front of a point that faces up: the middle of its lower edge is `along`
// beside the perpendicular and `low` above the point, m.
struct Window {
  double along, low, width, height;
};

// Illuminance of the point through the window, given the luminance of directions; the mean over many places.
template <typename Luminance>
double through(const Window& window, const Vec3d& facing, Luminance luminance) {
  constexpr int steps = 300;
  const auto beside = glm::cross(zenith, facing);
  double sum = 0.0;
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j) {
      const auto x = window.along + window.width * ((i + 0.5) / steps - 0.5);
      const auto z = window.low + window.height * (j + 0.5) / steps;
      const auto way = facing + x * beside + z * zenith;
      const auto r2 = glm::dot(way, way);
      sum += luminance(way / std::sqrt(r2)) * z / (r2 * r2);
    }
  return sum * window.width * window.height / (steps * steps);
}

// Largest errors of patches of one luminance in place of the sky, by 144 n² + 1 patches, n of 1, 2 and 4.
struct PatchErrors {
  int type;
  double elevation, azimuth;
  std::array<double, 3> largest;
};

TEST(SkyPatchLuminances, are_near_the_sky_through_windows) {
  constexpr PatchErrors skies[] = {{16, 30.0, 180.0, {0.015, 0.0045, 0.0015}},
                                   {1, 30.0, 180.0, {0.015, 0.0045, 0.0015}},
                                   {12, 30.0, 180.0, {0.06, 0.018, 0.004}},
                                   {12, 30.0, 0.0, {0.03, 0.009, 0.002}},
                                   {13, 60.0, 180.0, {0.02, 0.005, 0.001}}};
  constexpr Window windows[] = {{0.0, 0.05, 2.0, 1.0}, {0.1, 0.3, 0.6, 0.6}, {-0.2, 0.4, 0.3, 0.3}};
  const Vec3d south(0.0, -1.0, 0.0);
  constexpr std::array subdivisions{1, 2, 4};
  for (const auto& of : skies)
    for (std::size_t n = 0; n < subdivisions.size(); ++n) {
      const SkyPatches patches(subdivisions[n], zenith, north);
      const auto model = sky(of.type, of.elevation, of.azimuth);
      const auto luminances = sky_patch_luminances(model, patches, 10000.0, 0.0);
      const auto scale = 10000.0 / relative_illuminances(model).horizontal;
      for (const auto& window : windows) {
        const auto exact =
            through(window, south, [&](const Vec3d& d) { return scale * model.relative_luminance(d); });
        const auto patched =
            through(window, south, [&](const Vec3d& d) { return luminances[patches.patch_of(d)]; });
        EXPECT_LT(std::abs(patched / exact - 1.0), of.largest[n])
            << "type " << of.type << ", " << patches.size() << " patches, window of " << window.width << " m";
      }
    }
}

}  // namespace
}  // namespace luxel
