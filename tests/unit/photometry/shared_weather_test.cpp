// SPDX-License-Identifier: Apache-2.0
// Weather of Chicago O'Hare (TMY3 of NREL), which is not part of this repository: the tests are skipped where
// it does not lie beside it.
#include <filesystem>
#include <optional>

#include <gtest/gtest.h>

#include "luxel/photometry/weather.h"
#include "luxel/photometry/weather_figures.h"

namespace luxel {
namespace {

const auto chicago_file = std::filesystem::path(LUXEL_SOURCE_DIR) / "../shared/scenes/epw/chicago.epw";

class Chicago : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(chicago_file)) GTEST_SKIP() << chicago_file << " is not there";
    weather_ = load_weather(chicago_file.string());
  }
  Weather weather_;
};

TEST_F(Chicago, has_the_known_sums) {
  EXPECT_EQ(weather_.site.latitude, 41.98);
  EXPECT_EQ(weather_.site.longitude, -87.92);
  EXPECT_EQ(weather_.timezone, -6.0);
  EXPECT_EQ(weather_.hours.size(), 8760u);
  const auto figures = weather_figures(weather_);
  EXPECT_EQ(figures.light_hours, 4696.0);
  EXPECT_EQ(figures.sun_hours, 4208.0);
  EXPECT_EQ(figures.global, 1406646.0);
  EXPECT_EQ(figures.direct_normal, 1294257.0);
  EXPECT_EQ(figures.diffuse, 660253.0);
  EXPECT_FALSE(figures.is_modelled);
  EXPECT_EQ(figures.bright_half_hours, 4380.0);
  EXPECT_EQ(figures.bright_half_min, 1100.0);
  EXPECT_EQ(figures.bright_half_median, 15900.0);
  EXPECT_NEAR(100.0 * daylight_targets[0].target / figures.bright_half_median, 1.89, 0.005);
  EXPECT_NEAR(100.0 * daylight_targets[0].minimum / figures.bright_half_median, 0.63, 0.005);
}

// The irradiances of the file, the dew point of three hours, the place of the sun from gendaymtx.
TEST_F(Chicago, has_the_skies_of_gendaymtx) {
  struct Hour {
    unsigned month;
    double elevation, azimuth, direct, diffuse;
  };
  for (const auto& [month, elevation, azimuth, direct, diffuse] :
       {Hour{3, 47.0454, 191.3832, 81798.0, 17599.7}, Hour{9, 46.6093, 196.5261, 245.0, 35506.0}}) {
    const auto hour = find_hour(weather_, month, 21, 12.5);
    ASSERT_TRUE(hour.has_value());
    auto sun = sun_of(weather_, *hour);
    EXPECT_NEAR(sun.elevation, elevation, 1.1);  // gendaymtx's sun is off by up to 1.07 degrees
    sun.elevation = elevation;
    sun.direction = direction_towards(elevation, azimuth);
    const auto sky = perez_sky(weather_, *hour, sun);
    EXPECT_NEAR(sky.direct_normal_illuminance, direct, 1.0);
    EXPECT_NEAR(sky.diffuse_illuminance, diffuse, 5e-4 * diffuse);  // by the earth's orbit
  }
}

// The file's illuminances were made by NREL with efficacies of their own, of the same kind: 17,600 lx of
// gendaymtx are 16,900 there. Over the year the module's are 7.1 % higher (measured).
TEST_F(Chicago, has_illuminances_by_the_same_efficacies) {
  double file = 0.0, model = 0.0;
  for (std::size_t i = 0; i < weather_.hours.size(); ++i)
    if (const auto& hour = weather_.hours[i]; hour.diffuse_horizontal.value_or(0.0) > 0.0) {
      file += *hour.diffuse_illuminance;
      model += perez_sky(weather_, i, sun_of(weather_, i)).diffuse_illuminance;
    }
  EXPECT_NEAR(model / file, 1.0, 0.10);
}

TEST_F(Chicago, has_direct_light_at_sunrise_and_no_other_oddity) {
  EXPECT_TRUE(weather_.oddities.empty());
  ASSERT_EQ(weather_.notes.size(), 1u);
  EXPECT_NE(weather_.notes[0].find("with direct light, in whose middle the sun is below the horizon"),
            std::string::npos)
      << weather_.notes[0];
  // gendaymtx warns of 36 hours with more than 20 W/m² and no part of the sun above the horizon, by its own
  // sun.
  int bright = 0;
  for (std::size_t i = 0; i < weather_.hours.size(); ++i) {
    const auto& hour = weather_.hours[i];
    if (!(hour.direct_normal.value_or(0.0) > 0.0)) continue;
    EXPECT_GE(sun_of(weather_, i).elevation, 0.0) << hour.line;
    const auto middle = sun_position(hour.middle, weather_.site, {.pressure = 0.0});
    bright += *hour.direct_normal > 20.0 && middle.elevation < -0.5 * sun_diameter;
  }
  EXPECT_NEAR(bright, 36, 8);
}

}  // namespace
}  // namespace luxel
