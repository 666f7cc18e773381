// SPDX-License-Identifier: Apache-2.0
// The sun against a published position and against geometric identities.
#include "luxel/photometry/sun_position.h"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "luxel/core/error.h"

namespace luxel {
namespace {

Instant at(const std::string& text) { return instant_of(parse_civil_time(text)); }

constexpr Atmosphere no_air{0.0, 10.0};
constexpr Site greenwich{51.4779, 0.0};

// I. Reda, A. Andreas, "Solar position algorithm for solar radiation applications", NREL/TP-560-34302.
TEST(SunPosition, is_that_of_the_solar_position_algorithm) {
  const auto sun = sun_position(at("2003-10-17T12:30:30-07:00"), {39.742476, -105.1786}, {820.0, 11.0});
  EXPECT_NEAR(90.0 - sun.elevation, 50.11162, 0.001);
  EXPECT_NEAR(sun.azimuth, 194.34024, 0.002);
  EXPECT_NEAR(sun.distance, 0.9965422974, 3e-5);
  EXPECT_NEAR(glm::length(sun.direction), 1.0, 1e-12);
  EXPECT_NEAR(elevation_of(sun.direction), sun.elevation, 1e-9);
  EXPECT_NEAR(azimuth_of(sun.direction), sun.azimuth, 1e-9);
}

// The highest of a day: 90 degrees less latitude plus declination, due south.
TEST(SunPosition, culminates_at_the_declination_of_the_day) {
  struct Day {
    const char* date;
    double declination, tolerance;
  };
  // Equinox: the declination is 0 at 2026-03-20T14:46Z and changes by 0.0165 degrees per hour. Solstices:
  // plus and minus the obliquity of the ecliptic of 2026, 23.4360 with nutation.
  for (const auto& [date, declination, tolerance] :
       {Day{"2026-03-20", -0.045, 0.01}, Day{"2026-06-21", 23.436, 0.003},
        Day{"2026-12-21", -23.436, 0.003}}) {
    double highest = -90.0;
    Vec3d direction(0.0);
    for (int minute = 11 * 60; minute < 13 * 60; ++minute) {
      const auto sun =
          sun_position(at(std::string(date) + "T00:00Z") + std::chrono::minutes(minute), greenwich, no_air);
      if (sun.elevation > highest) direction = sun.direction;
      highest = std::max(highest, sun.elevation);
    }
    EXPECT_NEAR(highest, 90.0 - greenwich.latitude + declination - 0.0015, tolerance) << date;
    EXPECT_NEAR(direction.x, 0.0, 0.003);
    EXPECT_LT(direction.y, 0.0);
  }
}

// At the moment of the equinox the sun is over the equator, independent of the place: the sine of the
// elevation at the poles is 0, less the parallax.
TEST(SunPosition, is_over_the_equator_at_the_equinox) {
  // Times of the almanac, to the minute.
  for (const char* moment :
       {"2026-03-20T14:46Z", "2026-09-23T00:05Z", "1990-03-20T21:19Z", "2050-03-20T10:19Z"})
    EXPECT_NEAR(sun_position(at(moment), {90.0, 0.0}, no_air).elevation, -0.0024, 0.001) << moment;
}

// Apparent noon at Greenwich: the equation of time of 2026 from the almanac, minutes.
TEST(SunPosition, has_the_equation_of_time) {
  for (const auto& [date, minutes] : {std::pair("2026-02-11", -14.2), std::pair("2026-05-14", 3.65),
                                      std::pair("2026-07-26", -6.55), std::pair("2026-11-03", 16.45)}) {
    const auto noon = at(std::string(date) + "T12:00Z") - std::chrono::seconds(std::lround(60.0 * minutes));
    EXPECT_NEAR(sun_position(noon, greenwich, no_air).azimuth, 180.0, 0.06) << date;
  }
}

TEST(SunPosition, is_symmetric_about_noon_at_solstice) {
  // Within 6 hours the declination changes by 0.001 degrees and the equation of time by 3 s.
  auto noon = at("2026-06-21T12:00Z");
  while (sun_position(noon, greenwich).azimuth < 180.0) noon += std::chrono::seconds(1);
  for (const int hours : {1, 3, 6}) {
    const auto before = sun_position(noon - std::chrono::hours(hours), greenwich);
    const auto after = sun_position(noon + std::chrono::hours(hours), greenwich);
    EXPECT_NEAR(before.elevation, after.elevation, 0.02);
    EXPECT_NEAR(before.azimuth + after.azimuth, 360.0, 0.03);
  }
}

TEST(SunPosition, moves_with_longitude_and_mirrors_with_latitude) {
  const auto here = sun_position(at("2026-03-20T10:00Z"), {40.0, 15.0});
  const auto west = sun_position(at("2026-03-20T11:00Z"), {40.0, 0.0});
  EXPECT_NEAR(here.elevation, west.elevation, 0.02);  // the declination changes by 0.0165 degrees
  EXPECT_NEAR(here.azimuth, west.azimuth, 0.03);
  // In the south, the sun of the morning is north-east and rises to the left.
  const auto south = sun_position(at("2026-03-20T10:00Z"), {-40.0, 15.0});
  EXPECT_NEAR(south.azimuth, 180.0 - here.azimuth, 0.1);
  EXPECT_GT(here.azimuth, 90.0);
}

TEST(SunPosition, is_lifted_by_the_air_at_the_horizon) {
  const auto lift = [](double minutes) {
    const auto instant = at("2026-03-20T06:00Z") + std::chrono::seconds(std::lround(60.0 * minutes));
    const auto with = sun_position(instant, {0.0, 0.0}), without = sun_position(instant, {0.0, 0.0}, no_air);
    EXPECT_EQ(with.azimuth, without.azimuth);
    return std::pair(without.elevation, with.elevation - without.elevation);
  };
  const auto [low, at_horizon] = lift(7.5);  // sunrise at the equator, by the equation of time
  EXPECT_NEAR(low, 0.0, 0.1);
  EXPECT_NEAR(at_horizon, 0.48, 0.02);  // 29 minutes of arc at a true elevation of 0
  const auto [high, above] = lift(187.5);
  EXPECT_NEAR(high, 45.0, 0.1);
  EXPECT_NEAR(above, 1.0 / 60.0, 0.001);
  EXPECT_EQ(lift(0.0).second, 0.0);
}

TEST(CivilTime, is_read_in_the_forms_of_iso_8601) {
  const auto noon = at("2026-03-21T12:00Z");
  for (const char* text : {"2026-03-21T13:00+01:00", "2026-03-21T17:30+0530", "2026-03-21 06:00:00-06",
                           "2026-03-20T24:00-12:00", "2026-03-21T02:30-09:30"})
    EXPECT_EQ(at(text), noon) << text;
  EXPECT_EQ(instant_of(parse_civil_time("2026-03-21T17:45"), 5.75), noon);
  EXPECT_EQ(instant_of(parse_civil_time("2026-03-21T12:00Z"), 5.5), noon);  // its own time zone counts
  EXPECT_EQ(at("2024-02-29T12:00Z") - at("2024-02-28T12:00Z"), std::chrono::hours(24));
  EXPECT_EQ(text_of(noon, 5.5), "2026-03-21T17:30+05:30");
  EXPECT_EQ(text_of(noon + std::chrono::seconds(7), -9.5), "2026-03-21T02:30:07-09:30");
}

TEST(CivilTime, is_refused_where_it_is_none_or_has_no_time_zone) {
  for (const char* text :
       {"", "2026", "2026-03-21", "2026-3-21T12:00Z", "2026-02-29T12:00Z", "2026-13-01T12:00Z",
        "2026-03-21T25:00Z", "2026-03-21T24:01Z", "2026-03-21T12:60Z", "2026-03-21T12:00+15:00",
        "2026-03-21T12:00+1", "2026-03-21T12:00ZZ", "2026-03-21T12Z", "1500-03-21T12:00Z", "12:00"})
    EXPECT_THROW(parse_civil_time(text), InputError) << text;
  EXPECT_THROW(instant_of(parse_civil_time("2026-03-21T12:00")), InputError);
  EXPECT_EQ(parse_timezone("5.5"), 5.5);
  EXPECT_EQ(parse_timezone("+05:30"), 5.5);
  EXPECT_EQ(parse_timezone("-6"), -6.0);
  EXPECT_EQ(parse_timezone("+13"), 13.0);
  for (const char* text : {"", "x", "15", "-13", "5.5h", "nan", "+-3"})
    EXPECT_THROW(parse_timezone(text), InputError) << text;
}

}  // namespace
}  // namespace luxel
