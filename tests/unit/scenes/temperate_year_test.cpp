// SPDX-License-Identifier: Apache-2.0
#include "scenes/weather/temperate_year.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "luxel/photometry/weather_figures.h"

namespace luxel::scenes {
namespace {

TEST(TemperateYear, is_a_whole_year_without_oddities) {
  const auto weather = read_weather(temperate_year(), "made.wea");
  EXPECT_EQ(weather.hours.size(), 8760u);
  EXPECT_EQ(weather.oddities, std::vector<std::string>());
  EXPECT_EQ(weather.site.latitude, 50.0);
  EXPECT_EQ(weather.site.longitude, 10.0);
  EXPECT_EQ(weather.timezone, 1.0);
  const auto figures = weather_figures(weather);
  EXPECT_GT(figures.bright_half_median, 10'000.0);
  EXPECT_LT(figures.bright_half_median, 20'000.0);
}

// The formulas of the header, for a clear and an overcast hour.
TEST(TemperateYear, has_the_light_of_its_formulas) {
  const auto weather = read_weather(temperate_year(), "made.wea");
  const auto noon = *find_hour(weather, 6, 21, 12.0);  // day 172: u = 0.3018, below c = 0.4
  const auto sine = sun_of(weather, noon).direction.z;
  const auto elevation = sun_of(weather, noon).elevation;
  const auto mass = 1.0 / (sine + 0.50572 * std::pow(elevation + 6.07995, -1.6364));
  EXPECT_NEAR(*weather.hours[noon].direct_normal, 1353.0 * std::pow(0.7, std::pow(mass, 0.678)), 0.51);
  EXPECT_NEAR(*weather.hours[noon].diffuse_horizontal, 110.0 * std::pow(sine, 0.4), 0.51);
  const auto grey = *find_hour(weather, 6, 22, 12.0);  // day 173: u = 0.9199
  EXPECT_EQ(*weather.hours[grey].direct_normal, 0.0);
  EXPECT_NEAR(*weather.hours[grey].diffuse_horizontal, 300.0 * sun_of(weather, grey).direction.z, 0.51);
}

}  // namespace
}  // namespace luxel::scenes
