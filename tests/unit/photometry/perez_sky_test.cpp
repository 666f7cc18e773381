// SPDX-License-Identifier: Apache-2.0
// The all-weather sky against gendaymtx of Radiance, and against the shapes of its bins.
#include "luxel/photometry/perez_sky.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "luxel/photometry/sky_integrals.h"
#include "luxel/photometry/sun_position.h"

namespace luxel {
namespace {

// gendaymtx takes the earth's orbit from the day of the year (Spencer 1971).
double orbit_factor_of(int day) {
  const auto angle = (day - 1) * 2.0 * std::numbers::pi / 365.0;
  return 1.00011 + 0.034221 * std::cos(angle) + 0.00128 * std::sin(angle) + 0.000719 * std::cos(2.0 * angle) +
         0.000077 * std::sin(2.0 * angle);
}

TEST(PerezSky, has_air_between_clear_and_overcast) {
  const auto sun = direction_towards(40.0, 180.0);
  const auto clear = perez_sky({.direct_normal = 900.0, .diffuse_horizontal = 80.0}, sun);
  EXPECT_EQ(clear.bin, 8);
  const auto cloudy = perez_sky({.direct_normal = 0.0, .diffuse_horizontal = 200.0}, sun);
  EXPECT_EQ(cloudy.bin, 1);
  EXPECT_EQ(cloudy.clearness, 1.0);
  EXPECT_EQ(cloudy.direct_normal_illuminance, 0.0);
  // A clear sky is darkest opposite to the sun; an overcast one is brighter at the zenith than at the
  // horizon.
  const auto near = direction_towards(45.0, 180.0), far = direction_towards(50.0, 0.0);
  EXPECT_GT(clear.model.relative_luminance(near), 8.0 * clear.model.relative_luminance(far));
  EXPECT_GT(cloudy.model.relative_luminance({0.0, 0.0, 1.0}),
            1.5 * cloudy.model.relative_luminance(direction_towards(5.0, 0.0)));
}

// Irradiances of every bin and elevation give finite skies that are not negative, with efficacies of
// daylight.
TEST(PerezSky, is_sound_for_any_irradiances) {
  std::array<int, 9> found = {};
  for (const double elevation : {-3.0, 0.0, 2.0, 10.0, 35.0, 70.0, 89.9, 90.0})
    for (const double diffuse : {0.0, 1.0, 20.0, 100.0, 300.0, 700.0})
      for (const double direct : {0.0, 1.0, 10.0, 30.0, 100.0, 200.0, 400.0, 900.0}) {
        const auto sun = direction_towards(elevation, 123.0);
        const auto sky = perez_sky({.direct_normal = direct, .diffuse_horizontal = diffuse}, sun);
        ++found[static_cast<std::size_t>(sky.bin)];
        const auto part = relative_illuminances(sky.model);
        EXPECT_TRUE(std::isfinite(part.horizontal) && part.horizontal > 0.0)
            << elevation << " " << diffuse << " " << direct;
        EXPECT_GE(std::min({part.north, part.east, part.south, part.west}), 0.0);
        EXPECT_GE(sky.brightness, 0.01);
        EXPECT_LE(sky.brightness, 0.6);
        if (diffuse > 0.0) {
          EXPECT_GT(sky.diffuse_illuminance / diffuse, 50.0);
          EXPECT_LT(sky.diffuse_illuminance / diffuse, 683.0);  // of green light
        }
        EXPECT_GE(sky.direct_normal_illuminance, 0.0);
        EXPECT_LE(sky.direct_normal_illuminance, 130.0 * direct);
      }
  for (int bin = 1; bin <= 8; ++bin) EXPECT_GT(found[static_cast<std::size_t>(bin)], 0) << bin;
}

TEST(PerezSky, ignores_negative_irradiances) {
  const auto sun = direction_towards(40.0, 180.0);
  const auto sky = perez_sky({.direct_normal = -3.0, .diffuse_horizontal = 100.0}, sun);
  EXPECT_EQ(sky.clearness, 1.0);
  EXPECT_EQ(sky.direct_normal_illuminance, 0.0);
  EXPECT_EQ(perez_sky({.direct_normal = 5.0, .diffuse_horizontal = -1.0}, sun).diffuse_illuminance, 0.0);
}

struct Anchor {
  double elevation, azimuth;
  int day;
  PerezInput input;
  double clearness, brightness, direct, diffuse;
  std::array<double, 5> parameters;
};

// gendaymtx of Radiance, commit bcffc2b5, for two hours of TMY3 of Chicago O'Hare, both at 12:30 by its own
// sun; dew points are the mean of three hours.
const Anchor anchors[] = {{47.0454,
                           191.3832,
                           80,
                           {810.0, 133.0, -8.5},
                           5.23331,
                           0.131696,
                           81798.0,
                           17599.7,
                           {-0.9685, -0.2245, 15.2268, -3.9044, 0.5846}},
                          {46.6093,
                           196.5261,
                           264,
                           {3.0, 308.0, 38.8 / 3.0},
                           1.00671,
                           0.312107,
                           245.0,
                           35506.0,
                           {0.7339, -0.3982, 1.7721, -1.0210, -0.0023}}};

TEST(PerezSky, is_that_of_gendaymtx) {
  for (const auto& a : anchors) {
    auto input = a.input;
    input.orbit_factor = orbit_factor_of(a.day);
    const auto sky = perez_sky(input, direction_towards(a.elevation, a.azimuth));
    EXPECT_NEAR(sky.clearness, a.clearness, 1e-5 * a.clearness);
    EXPECT_NEAR(sky.brightness, a.brightness, 1e-5 * a.brightness);
    EXPECT_NEAR(sky.diffuse_illuminance, a.diffuse, 1e-5 * a.diffuse);
    EXPECT_NEAR(sky.direct_normal_illuminance, a.direct, std::max(0.51, 1e-5 * a.direct));
    for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(sky.parameters[i], a.parameters[i], 5.1e-5) << i;
  }
}

}  // namespace
}  // namespace luxel
