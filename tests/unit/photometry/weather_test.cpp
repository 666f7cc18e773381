// SPDX-License-Identifier: Apache-2.0
// Weather files of known light: the meaning of their time stamps, time zones and missing values.
#include "luxel/photometry/weather.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "luxel/core/error.h"
#include "luxel/photometry/weather_figures.h"

#include "support/weather_file.h"

namespace luxel {
namespace {

std::string all_of(const std::vector<std::string>& sentences) {
  std::string text;
  for (const auto& sentence : sentences) text += sentence + "\n";
  return text;
}

std::string with(std::string text, const std::string& old, const std::string& now) {
  const auto at = text.find(old);
  EXPECT_NE(at, std::string::npos) << old;
  return text.replace(at, old.size(), now);
}

std::string error_of(const std::string& text) {
  try {
    read_weather(text, "w.epw");
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

TEST(Epw, is_read_with_half_an_hour_in_its_time_zone) {
  const auto weather = read_weather(made_epw({}), "delhi.epw");
  EXPECT_EQ(weather.place, "New Delhi, IND");
  EXPECT_EQ(weather.timezone, 5.5);
  EXPECT_EQ(weather.site.longitude, 77.2);
  EXPECT_EQ(weather.elevation, 216.0);
  ASSERT_EQ(weather.hours.size(), 8760u);
  EXPECT_EQ(all_of(weather.oddities), "");
  const auto noon = find_hour(weather, 3, 21, 13.0);
  ASSERT_TRUE(noon.has_value());
  EXPECT_EQ(weather.hours[*noon].end, 13.0);
  EXPECT_EQ(weather.hours[*noon].middle, instant_of(parse_civil_time("2023-03-21T12:30+05:30")));
  EXPECT_EQ(weather.hours[*noon].dew_point, 10.0);
  // The light of every record is that of the sun that the module finds for it.
  for (std::size_t i = 0; i < weather.hours.size(); i += 7) {
    const auto light = made_light(sun_of(weather, i));
    EXPECT_NEAR(*weather.hours[i].global_horizontal, light.global, 0.001);
  }
}

TEST(Epw, may_have_a_leap_day_and_no_field_for_it) {
  const auto text = made_epw({.has_leap_day = true});
  const auto weather = read_weather(with(text, "HOLIDAYS/DAYLIGHT SAVINGS,Yes,0,0,0\n", ""), "leap.epw");
  EXPECT_TRUE(weather.has_leap_day);
  EXPECT_EQ(weather.hours.size(), 8784u);
  EXPECT_EQ(all_of(weather.oddities), "");
  const auto leap = find_hour(weather, 2, 29, 11.25);
  ASSERT_TRUE(leap.has_value());
  EXPECT_EQ(weather.hours[*leap].middle, instant_of(parse_civil_time("2024-02-29T11:30+05:30")));
  EXPECT_EQ(weather.hours.back().middle, instant_of(parse_civil_time("2024-12-31T23:30+05:30")));
}

TEST(Epw, may_have_several_records_per_hour) {
  const auto weather = read_weather(made_epw({.per_hour = 4}), "quarters.epw");
  ASSERT_EQ(weather.hours.size(), 4u * 8760u);
  const auto noon = find_hour(weather, 6, 1, 12.3);
  ASSERT_TRUE(noon.has_value());
  EXPECT_EQ(weather.hours[*noon].middle, instant_of(parse_civil_time("2023-06-01T12:22:30+05:30")));
  EXPECT_NEAR(*weather.hours[*noon].direct_normal, 800.0, 0.01);  // 200 Wh/m² in a quarter of an hour
  EXPECT_EQ(all_of(weather.oddities), "");
  ASSERT_EQ(weather.notes.size(), 1u);
  EXPECT_NE(weather.notes[0].find("4 records per hour; their radiation counts as Wh/m² per record"),
            std::string::npos);
  // The sums of a year do not depend on the length of records.
  const auto quarters = weather_figures(weather),
             hours = weather_figures(read_weather(made_epw({}), "h.epw"));
  EXPECT_NEAR(quarters.global / hours.global, 1.0, 0.002);
  EXPECT_NEAR(quarters.sun_hours / hours.sun_hours, 1.0, 0.005);
  EXPECT_EQ(quarters.bright_half_hours, 4380.0);
}

// Files that have W/m² in records of a part of an hour.
TEST(Epw, of_several_records_in_watts_is_recognised) {
  const auto weather = read_weather(made_epw({.per_hour = 2, .is_in_watts = true}), "watts.epw");
  EXPECT_NE(all_of(weather.notes).find("2 records per hour; their radiation counts as mean W/m²"),
            std::string::npos)
      << all_of(weather.oddities);
  EXPECT_EQ(*weather.hours[*find_hour(weather, 6, 1, 12.3)].direct_normal, 800.0);
}

TEST(Epw, has_oddities_where_its_stamps_or_time_zone_are_wrong) {
  const auto late = all_of(read_weather(made_epw({.shift = 0.5}), "late.epw").oddities);
  EXPECT_NE(late.find("fit each other best with the sun of 30 minutes later"), std::string::npos) << late;
  const auto early = all_of(read_weather(made_epw({.shift = -1.0}), "early.epw").oddities);
  EXPECT_NE(early.find("fit each other best with the sun of 60 minutes before"), std::string::npos) << early;
  const auto west = all_of(read_weather(made_epw({.written_longitude = -77.2}), "west.epw").oddities);
  EXPECT_NE(west.find("one of them has the wrong sign"), std::string::npos) << west;
  EXPECT_NE(west.find("of light while the sun is more than 3 degrees below the horizon"), std::string::npos)
      << west;
}

TEST(Epw, has_missing_values_as_nothing) {
  const auto weather = read_weather(made_epw({.has_illuminances = false}), "bare.epw");
  EXPECT_EQ(all_of(weather.oddities), "");
  for (const auto& hour : weather.hours) EXPECT_FALSE(hour.diffuse_illuminance || hour.global_illuminance);
  const auto figures = weather_figures(weather);
  EXPECT_TRUE(figures.is_modelled);
  EXPECT_GT(figures.bright_half_median, 8000.0);  // 100 W/m² of a clear sky
  EXPECT_LT(figures.bright_half_median, 20000.0);
  const std::string row = "1991,1,1,12,60,?9?9?9,20.0,10.0,";
  auto text = made_epw({});
  const auto at = text.find(row);
  ASSERT_NE(at, std::string::npos);
  text.replace(at, text.find('\n', at) - at,
               "1991,1,1,12,60,?9?9?9,20.0,99.9,50,99000,0,0,300,9999,9999,,999999,999999,999999");
  const auto gap = read_weather(text, "gap.epw");
  const auto& hour = gap.hours[11];
  EXPECT_FALSE(hour.global_horizontal || hour.direct_normal || hour.diffuse_horizontal || hour.dew_point);
  EXPECT_FALSE(hour.diffuse_illuminance);
  EXPECT_NE(all_of(gap.oddities).find("gap.epw:20: 1 record without direct or diffuse radiation"),
            std::string::npos)
      << all_of(gap.oddities);
  EXPECT_NE(all_of(gap.oddities).find("gap.epw: 1 record without a dew point"), std::string::npos);
  EXPECT_EQ(mean_dew_point(gap, 11), 10.0);
}

// A file of a program without illuminances: 0 or 9999 everywhere.
TEST(Epw, has_no_illuminances_where_all_are_equal) {
  auto text = made_epw({.has_illuminances = false});
  for (auto at = text.find("999999,999999,999999"); at != std::string::npos;
       at = text.find("999999,999999,999999", at))
    text.replace(at, 20, "9999,9999,9999");
  const auto weather = read_weather(text, "same.epw");
  EXPECT_FALSE(weather.hours[12].diffuse_illuminance.has_value());
  EXPECT_NE(all_of(weather.oddities).find("all diffuse illuminances are 9999"), std::string::npos);
}

TEST(Epw, may_be_a_part_of_a_year_or_have_gaps) {
  auto text = made_epw({});
  const auto begin = text.find("1993,3,1,"), end = text.find("1994,4,1,");
  const auto weather = read_weather(text.erase(begin, end - begin), "gap.epw");
  EXPECT_EQ(weather.hours.size(), 8760u - 31u * 24u);
  const auto odd = all_of(weather.oddities);
  EXPECT_NE(odd.find("8016 records, where a year has 8760"), std::string::npos) << odd;
  EXPECT_NE(odd.find("gap.epw:1425: this record does not follow the one before it"), std::string::npos)
      << odd;
  EXPECT_FALSE(find_hour(weather, 3, 21, 12.0).has_value());
}

TEST(Epw, counts_negative_values_as_0) {
  const auto text = with(made_epw({}), "60,?9?9?9,20.0,10.0,50,99000,0,0,300,0.000,0.000,0.000,",
                         "60,?9?9?9,20.0,10.0,50,99000,0,0,300,-1.5,0.000,-2,");
  const auto weather = read_weather(text, "n.epw");
  EXPECT_EQ(weather.hours[0].diffuse_horizontal, 0.0);
  EXPECT_NE(all_of(weather.oddities).find("n.epw:9: 2 values below 0 count as 0"), std::string::npos)
      << all_of(weather.oddities);
}

// In the hour of sunrise the mean of the hour has direct light, though the sun is down in its middle.
TEST(Weather, has_the_sun_above_the_horizon_where_it_shines) {
  auto weather = read_weather(made_epw({}), "delhi.epw");
  const auto dawn = find_hour(weather, 12, 15, 6.5);
  ASSERT_TRUE(dawn.has_value());
  auto& hour = weather.hours[*dawn];
  EXPECT_LT(sun_of(weather, *dawn).elevation, -5.0);
  hour.direct_normal = 50.0;
  EXPECT_LT(sun_of(weather, *dawn).elevation, 0.0);  // it never rises in this hour
  EXPECT_EQ(perez_sky(weather, *dawn, sun_of(weather, *dawn)).direct_normal_illuminance, 0.0);
  hour.middle += std::chrono::minutes(18);
  EXPECT_LT(sun_position(hour.middle, weather.site).elevation, 0.0);
  const auto sun = sun_of(weather, *dawn);
  EXPECT_GT(sun.elevation, 0.0);
  EXPECT_LT(sun.elevation, 3.0);
}

TEST(Epw, is_refused_with_its_line) {
  const auto text = made_epw({});
  EXPECT_EQ(error_of(""),
            "w.epw:1: expected a weather file, which begins with LOCATION (EPW) or place (WEA), found ''");
  EXPECT_NE(error_of("LOCATION,a,b\n").find("w.epw:1: expected LOCATION with 9 fields"), std::string::npos);
  EXPECT_NE(error_of(with(text, ",28.6,", ",north,"))
                .find("w.epw:1: expected the latitude, a number, found 'north'"),
            std::string::npos);
  EXPECT_NE(
      error_of(with(text, ",28.6,", ",286,")).find("w.epw:1: expected a latitude from -90 to 90, found 286"),
      std::string::npos);
  EXPECT_NE(
      error_of(with(text, "PERIODS,1,1,", "PERIODS,1,7,")).find("w.epw:8: expected the number of records"),
      std::string::npos);
  EXPECT_NE(error_of(with(text, "1991,1,1,2,", "1991,1,1,1,"))
                .find("w.epw:10: hour 1 of day 1 of month 1 has more than 1 record"),
            std::string::npos);
  EXPECT_NE(error_of(with(text, "1991,1,1,1,", "1991,1,1,0,"))
                .find("w.epw:9: expected the hour, 1 to 24, found '0'"),
            std::string::npos);
  EXPECT_NE(error_of(with(text, "1992,2,28,24,", "1992,2,30,24,")).find("month 2 has no day 30"),
            std::string::npos);
  EXPECT_NE(error_of(with(text, "0.000,0.000,0.000", "0.000,none,0.000"))
                .find("w.epw:9: expected the direct normal radiation, a number, found 'none'"),
            std::string::npos);
  EXPECT_NE(error_of(text.substr(0, text.find("1991,"))).find("ends before its first hour"),
            std::string::npos);
  EXPECT_NE(error_of(text.substr(0, text.find("1991,") + 30))
                .find("w.epw:9: expected a record of at least 16 fields"),
            std::string::npos);
  EXPECT_THROW(load_weather("nowhere.epw"), InputError);
}

const std::string wea =
    "place Oakland_USA\nlatitude 37.72\nlongitude 122.22\ntime_zone 120.0\nsite_elevation 2\n"
    "weather_data_file_units 1\n";

TEST(Wea, has_west_positive_and_a_meridian_for_a_time_zone) {
  const auto weather = read_weather(wea + "3 21 12.5 700 120\n3 21 13.5 650 130\n", "oak.wea");
  EXPECT_EQ(weather.place, "Oakland USA");
  EXPECT_EQ(weather.site.longitude, -122.22);
  EXPECT_EQ(weather.timezone, -8.0);
  ASSERT_EQ(weather.hours.size(), 2u);
  EXPECT_EQ(weather.hours[0].middle, instant_of(parse_civil_time("2023-03-21T12:30-08:00")));
  EXPECT_EQ(weather.hours[0].end, 13.0);
  EXPECT_EQ(weather.hours[0].direct_normal, 700.0);
  EXPECT_EQ(weather.hours[1].diffuse_horizontal, 130.0);
  EXPECT_FALSE(weather.hours[0].global_horizontal);
  EXPECT_GT(sun_of(weather, 0).elevation, 50.0);
  EXPECT_EQ(find_hour(weather, 3, 21, 13.0), 0u);
  EXPECT_EQ(find_hour(weather, 3, 21, 13.5), 1u);
  const auto figures = weather_figures(weather);
  EXPECT_FALSE(figures.has_global);
  EXPECT_NEAR(figures.global,
              250.0 + 700.0 * sun_of(weather, 0).direction.z + 650.0 * sun_of(weather, 1).direction.z, 1e-9);
  const auto india =
      read_weather(with(with(wea, "122.22", "-77.2"), "120.0", "-82.5") + "3 21 12.5 700 120\n", "i.wea");
  EXPECT_EQ(india.timezone, 5.5);
  EXPECT_EQ(india.site.longitude, 77.2);
  const auto kiribati =
      read_weather(with(with(wea, "122.22", "157.4"), "120.0", "-210") + "3 21 12.5 700 120\n", "k.wea");
  EXPECT_EQ(kiribati.timezone, 14.0);
}

TEST(Wea, has_three_kinds_of_units) {
  const auto horizontal = read_weather(with(wea, "units 1", "units 2") + "3 21 12.5 500 120\n", "h.wea");
  EXPECT_NEAR(*horizontal.hours[0].direct_normal, 500.0 / sun_of(horizontal, 0).direction.z, 1e-9);
  const auto lux = read_weather(with(wea, "units 1", "units 3") + "3 21 12.5 70000 15000\n", "l.wea");
  EXPECT_EQ(lux.hours[0].direct_normal_illuminance, 70000.0);
  EXPECT_FALSE(lux.hours[0].direct_normal);
  const auto sky = perez_sky(lux, 0, sun_of(lux, 0));
  EXPECT_EQ(sky.diffuse_illuminance, 15000.0);
  // The irradiances that were found belong to a clear sky, as those of which these illuminances are.
  const auto back = read_weather(wea + "3 21 12.5 690 116\n", "w.wea");
  const auto same = perez_sky(back, 0, sun_of(back, 0));
  EXPECT_EQ(sky.bin, same.bin);
  EXPECT_NEAR(sky.direct_normal_illuminance / same.direct_normal_illuminance, 1.0, 0.1);
  // More than the sun gives at this elevation.
  const auto bright = read_weather(with(wea, "units 1", "units 2") + "12 21 8.0 500 20\n", "b.wea");
  EXPECT_EQ(*bright.hours[0].direct_normal, 1367.0);
  EXPECT_NE(all_of(bright.oddities).find("more than a sun of 1367 W/m²"), std::string::npos);
}

TEST(Wea, is_refused_with_its_line) {
  EXPECT_NE(error_of("place x\nlatitude 1\n3 21 12.5 1 1\n").find("w.epw:3: the header lacks longitude"),
            std::string::npos);
  EXPECT_NE(error_of(with(wea, "units 1", "units 4") + "3 21 12.5 1 1\n")
                .find("w.epw:6: expected weather_data_file_units 1, 2 or 3"),
            std::string::npos);
  EXPECT_NE(
      error_of(wea + "3 21 12.5 1\n").find("w.epw:7: expected month, day, hour, direct and diffuse, found 4"),
      std::string::npos);
  EXPECT_NE(error_of(wea + "2 30 12.5 1 1\n").find("w.epw:7: expected month and day, found '2 30'"),
            std::string::npos);
  EXPECT_NE(error_of(wea + "2 3 25 1 1\n").find("w.epw:7: expected the hour"), std::string::npos);
  EXPECT_NE(error_of(wea + "2 3 12.5 1 1\n2 3 12.5 1 1\n").find("w.epw:8: expected an hour after 12.5"),
            std::string::npos);
  EXPECT_NE(error_of(with(wea, "place Oakland_USA\nlatitude", "place Oakland_USA\nheight"))
                .find("w.epw:2: expected a line of the header"),
            std::string::npos);
  EXPECT_NE(error_of(wea).find("ends before its first hour"), std::string::npos);
}

}  // namespace
}  // namespace luxel
