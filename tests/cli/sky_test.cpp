// SPDX-License-Identifier: Apache-2.0
// End-to-end tests of skies, the sun and weather files.
#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "luxel/image/image_file.h"
#include "luxel/photometry/sun_position.h"

#include "cli/run_program.h"
#include "support/weather_file.h"

namespace luxel::cli {
namespace {

using Json = nlohmann::json;

Json sky_of(const std::filesystem::path& folder, const std::string& arguments) {
  const auto run = cli::run(folder, "$LUXEL sky " + arguments + " --json");
  EXPECT_EQ(run.code, 0) << arguments << ": " << run.err;
  EXPECT_EQ(run.err, "") << arguments;
  return Json::parse(run.out);
}

TEST(SkyCommand, has_the_known_ratios_and_the_energy) {
  const auto folder = fresh_folder("sky_ratios");
  struct Row {
    const char* arguments;
    double ratio;
  };
  for (const auto& [arguments, ratio] :
       {Row{"cie:1", 2.44954}, Row{"cie:3", 2.76999}, Row{"cie:5", 3.14159},
        Row{"cie:12 --sun 60,180", 3.19057}, Row{"cie:12 --sun 30,77", 6.39411},
        Row{"cie:14 --sun 30,180", 7.70810}, Row{"cie:16", 2.44346}, Row{"uniform --sun 30,180", 3.14159}}) {
    const auto json = sky_of(folder, std::string(arguments) + " --sky-illuminance 7000");
    EXPECT_NEAR(json["horizontal_over_zenith"].get<double>(), ratio, 5.1e-6) << arguments;
    EXPECT_NEAR(json["horizontal_illuminance"].get<double>(), 7000.0, 1e-9) << arguments;
    EXPECT_NEAR(json["zenith_luminance"].get<double>() * ratio, 7000.0, 0.03) << arguments;
    EXPECT_EQ(json["direct_normal_illuminance"], nullptr);
  }
  const auto overcast = sky_of(folder, "cie:16");
  EXPECT_EQ(overcast["command"], "sky");
  EXPECT_EQ(overcast["kind"], "cie:16");
  EXPECT_EQ(overcast["sun"], nullptr);
  for (const char* side : {"north", "east", "south", "west"})
    EXPECT_NEAR(overcast["vertical_illuminance"][side].get<double>(),
                10000.0 * (3.0 / 14.0 + 4.0 / (7.0 * std::numbers::pi)), 0.01);
  EXPECT_NEAR(overcast["ground_luminance"].get<double>(), 2000.0 / std::numbers::pi, 0.001);
}

TEST(SkyCommand, has_the_sun_of_a_date) {
  const auto folder = fresh_folder("sky_date");
  // The hour of the solar position algorithm's example, at sea level.
  const auto sun =
      sky_of(folder, "cie:12 --date 2003-10-17T12:30:30-07:00 --place 39.742476,-105.1786")["sun"];
  EXPECT_NEAR(sun["elevation"].get<double>(), 90.0 - 50.11162, 0.01);
  EXPECT_NEAR(sun["azimuth"].get<double>(), 194.34024, 0.01);
  const std::string delhi = " --place 28.6,77.2";
  const auto written = sky_of(folder, "cie:12 --date 2026-03-21T12:00+05:30" + delhi);
  EXPECT_EQ(sky_of(folder, "cie:12 --date 2026-03-21T12:00 --timezone 5.5" + delhi), written);
  EXPECT_EQ(sky_of(folder, "cie:12 --date 2026-03-21T06:30Z" + delhi), written);
  const auto turned = sky_of(folder, "cie:12 --sun 30,-90")["sun"];
  EXPECT_NEAR(turned["azimuth"].get<double>(), 270.0, 1e-9);
}

TEST(SkyCommand, has_the_all_weather_sky_of_irradiances) {
  const auto folder = fresh_folder("sky_perez");
  const auto json = sky_of(
      folder, "perez --sun 47.0454,191.3832 --direct-normal 810 --diffuse-horizontal 133 --dew-point -8.5");
  // gendaymtx, whose sun was 0.8 % nearer on that day.
  EXPECT_NEAR(json["direct_normal_illuminance"].get<double>() / 81798.0, 1.0, 1e-3);
  EXPECT_NEAR(json["horizontal_illuminance"].get<double>() / 17599.7, 1.0, 1e-3);
  EXPECT_NEAR(json["perez"]["clearness"].get<double>(), 5.23331, 1e-5);
  EXPECT_NEAR(json["perez"]["brightness"].get<double>() * 0.9921, 0.131696, 1e-4);
  EXPECT_EQ(json["perez"]["bin"], 7);
  EXPECT_NEAR(json["direct_horizontal_illuminance"].get<double>(),
              json["direct_normal_illuminance"].get<double>() * std::sin(47.0454 * std::numbers::pi / 180.0),
              0.1);
  EXPECT_NEAR(
      json["ground_luminance"].get<double>() * std::numbers::pi / 0.2,
      json["direct_horizontal_illuminance"].get<double>() + json["horizontal_illuminance"].get<double>(),
      0.01);
  const auto set = sky_of(folder, "perez --sun 47,191 --diffuse-horizontal 133 --sky-illuminance 5000");
  EXPECT_NEAR(set["horizontal_illuminance"].get<double>(), 5000.0, 1e-9);
  EXPECT_EQ(set["direct_normal_illuminance"], 0.0);
}

TEST(SkyCommand, draws_all_directions_in_candelas_per_square_metre) {
  const auto folder = fresh_folder("sky_exr");
  const auto json = sky_of(folder, "cie:12 --sun 30,90 --albedo 0.5 -o sky.exr");
  EXPECT_EQ(json["outputs"], Json{"sky.exr"});
  const auto image = read_image(folder / "sky.exr");
  double horizontal = 0.0, east = 0.0, below = 0.0;
  Vec3d brightest(0.0);
  float highest = 0.0f;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const auto elevation = 90.0 - 180.0 * (y + 0.5) / image.height;
      const auto d = direction_towards(elevation, 360.0 * (x + 0.5) / image.width);
      const auto solid_angle = std::cos(elevation * std::numbers::pi / 180.0) * 2.0 * std::numbers::pi *
                               std::numbers::pi / image.width / image.height;
      const auto light = solid_angle * static_cast<double>(image.at(x, y).g);
      if (image.at(x, y).g > highest) brightest = d;
      highest = std::max(highest, image.at(x, y).g);
      (d.z > 0.0 ? horizontal : below) += light * std::abs(d.z);
      if (d.z > 0.0) east += light * std::max(0.0, d.x);
    }
  EXPECT_NEAR(horizontal, 10000.0, 10.0);
  EXPECT_NEAR(east, json["vertical_illuminance"]["east"].get<double>(), 20.0);
  EXPECT_NEAR(below, 5000.0, 5.0);
  EXPECT_GT(glm::dot(brightest, direction_towards(30.0, 90.0)), std::cos(0.5 * std::numbers::pi / 180.0));
}

TEST(SkyCommand, draws_the_dome_with_north_at_the_top) {
  const auto folder = fresh_folder("sky_png");
  ASSERT_EQ(cli::run(folder, "$LUXEL sky cie:12 --sun 30,90 -o east.png").code, 0);
  ASSERT_EQ(cli::run(folder, "$LUXEL sky cie:12 --sun 30,180 -o dome.png").code, 0);
  EXPECT_EQ(read_image(folder / "dome.png").pixels,
            read_image(LUXEL_SOURCE_DIR "/docs/images/sky-dome.png").pixels);
  const auto image = read_image(folder / "east.png");
  EXPECT_EQ(image.width, 720);
  EXPECT_EQ(image.height, 640);
  const auto at = [&](double elevation, double azimuth) {
    const auto r = 270.0 * (1.0 - elevation / 90.0);
    const auto turn = direction_towards(0.0, azimuth);
    return luminance(image.at(static_cast<int>(320.0 + r * turn.x), static_cast<int>(320.0 - r * turn.y)));
  };
  EXPECT_GT(at(20.0, 90.0), 3.0f * at(20.0, 270.0));  // east is on the right
  EXPECT_NEAR(at(45.0, 10.0), at(45.0, 170.0), 0.01f);
}

TEST(SkyCommand, has_the_sky_of_an_hour_of_a_weather_file) {
  const auto folder = fresh_folder("sky_weather");
  std::ofstream(folder / "delhi.epw") << made_epw({});
  const auto json = sky_of(folder, "perez --weather delhi.epw --hour 2026-03-21T13");
  EXPECT_EQ(json["weather"]["middle"], "2023-03-21T12:30+05:30");
  EXPECT_EQ(json["weather"]["direct_normal_irradiance"], 800.0);
  EXPECT_EQ(json["weather"]["dew_point"], 10.0);
  for (const char* same : {"03-21T13", "03-21T12:30", "03-21T12:01", "2019-03-21T13:00"})
    EXPECT_EQ(sky_of(folder, std::string("perez --weather delhi.epw --hour ") + same), json) << same;
  const auto date = sky_of(folder, "cie:12 --date 2023-03-21T12:30+05:30 --place 28.6,77.2");
  EXPECT_NEAR(date["sun"]["elevation"].get<double>(), json["sun"]["elevation"].get<double>(), 1e-9);
  // Another kind of sky has the sun and the illuminance of the hour.
  const auto clear = sky_of(folder, "cie:12 --weather delhi.epw --hour 03-21T13");
  EXPECT_EQ(clear["sun"], json["sun"]);
  EXPECT_NEAR(clear["horizontal_illuminance"].get<double>(), json["horizontal_illuminance"].get<double>(),
              1e-6);
  EXPECT_EQ(clear["direct_normal_illuminance"], json["direct_normal_illuminance"]);
  const auto night = sky_of(folder, "perez --weather delhi.epw --hour 03-21T24");
  EXPECT_EQ(night["horizontal_illuminance"], 0.0);
  EXPECT_EQ(night["zenith_luminance"], 0.0);
}

TEST(SkyCommand, refuses_in_one_sentence_what_it_cannot_draw) {
  const auto folder = fresh_folder("sky_misuse");
  std::ofstream(folder / "delhi.epw") << made_epw({});
  std::ofstream(folder / "bad.epw") << "LOCATION,x\n";
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"cie:0", "expected a sky: cie:1 to cie:16, uniform or perez, not 'cie:0'"},
      {"cie:1x", "not 'cie:1x'"},
      {"cie:12", "cie:12 needs the sun: --sun ELEV,AZ"},
      {"cie:12 --sun 30", "--sun: expected two numbers in degrees such as 30,180, not '30'"},
      {"cie:12 --sun 91,0", "--sun: expected two numbers"},
      {"cie:12 --sun nan,0", "--sun: expected two numbers"},
      {"cie:12 --sun -5,0", "the sun is 5.00 degrees below the horizon"},
      {"cie:12 --date 2026-03-21T12:00 --place 52,13",
       "has no time zone: add it, as in 2026-03-21T12:00+01:00"},
      {"cie:12 --date 2026-03-21T12:00Z", "--date needs --place"},
      {"cie:12 --date noon --place 52,13", "--date: 'noon' is no date and time"},
      {"cie:12 --date 2026-03-21T12:00Z --place 52,13 --timezone 1",
       "--date has the time zone +0 h, and --timezone has +1 h"},
      {"cie:12 --date 2026-03-21T12:00 --place 52,13 --timezone x", "--timezone: 'x' is no time zone"},
      {"cie:12 --sun 30,0 --date 2026-03-21T12:00Z --place 52,13", "--sun and --date both place the sun"},
      {"cie:12 --sun 30,0 --place 52,13", "--place needs --date"},
      {"uniform --direct-normal 5", "--direct-normal is used with perez only"},
      {"perez --sun 30,0", "perez needs the irradiances"},
      {"perez --diffuse-horizontal 100", "perez needs the sun"},
      {"perez --weather delhi.epw", "--weather needs --hour"},
      {"perez --hour 03-21T13", "--hour needs --weather"},
      {"perez --weather delhi.epw --hour 02-29T13", "has no record of month 2, day 29, 13 h"},
      {"perez --weather delhi.epw --hour 02-30T13", "--hour: expected month, day and hour"},
      {"perez --weather delhi.epw --hour 03-21T0", "--hour: expected month, day and hour"},
      {"perez --weather delhi.epw --hour 03-21T13 --dew-point 3",
       "--dew-point: the weather file has its own"},
      {"cie:16 -o sky.jpg", "sky.jpg"},
      {"cie:16 --albedo 2", "--albedo: expected a number from 0 to 1"}};
  for (const auto& [arguments, sentence] : cases) {
    const auto run = cli::run(folder, "$LUXEL sky " + arguments);
    EXPECT_EQ(run.code, 2) << arguments;
    EXPECT_EQ(run.out, "") << arguments;
    EXPECT_NE(run.err.find(sentence), std::string::npos) << arguments << "\n" << run.err;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  }
  EXPECT_EQ(cli::run(folder, "$LUXEL sky perez --weather bad.epw --hour 03-21T13").code, 1);
}

TEST(SkyCommand, leaves_out_oddities_where_it_is_told_to_be_quiet) {
  const auto folder = fresh_folder("sky_quiet");
  std::ofstream(folder / "short.wea")
      << "place A_B\nlatitude 48\nlongitude -11\ntime_zone -15\nsite_elevation 5\n"
         "weather_data_file_units 1\n6 1 12.5 700 100\n";
  const std::string line = "$LUXEL sky perez --weather short.wea --hour 06-01T12:30";
  const auto loud = cli::run(folder, line), quiet = cli::run(folder, line + " --quiet");
  EXPECT_EQ(loud.code, 0) << loud.err;
  EXPECT_NE(loud.err.find("1 record, where a year has 8760"), std::string::npos) << loud.err;
  EXPECT_EQ(quiet.code, 0) << quiet.err;
  EXPECT_EQ(quiet.err, "");
  EXPECT_EQ(quiet.out, loud.out);
}

TEST(WeatherCommand, prints_what_a_designer_asks_of_a_place) {
  const auto folder = fresh_folder("weather");
  std::ofstream(folder / "delhi.epw") << made_epw({});
  const auto run = cli::run(folder, "$LUXEL weather delhi.epw");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  for (const char* words :
       {"delhi.epw: EPW, New Delhi, IND\n", "28.6° north, 77.2° east, 216 m, UTC+05:30", "8760 of 1 h",
        "4380 h of the highest diffuse illuminance", "for 300 lx", "brightest hours"})
    EXPECT_NE(run.out.find(words), std::string::npos) << words << "\n" << run.out;
  EXPECT_EQ(run.out.find("oddities"), std::string::npos) << run.out;
  const auto json = Json::parse(cli::run(folder, "$LUXEL weather delhi.epw --json").out);
  EXPECT_EQ(json["command"], "weather");
  EXPECT_EQ(json["timezone"], 5.5);
  EXPECT_EQ(json["longitude"], 77.2);
  EXPECT_EQ(json["records"], 8760);
  EXPECT_NEAR(json["direct_normal"].get<double>(), 800.0 * json["sun_hours"].get<double>(), 0.1);
  EXPECT_NEAR(json["diffuse_horizontal"].get<double>(), 100.0 * json["light_hours"].get<double>(), 0.1);
  // 12,000 lx, and a tenth more per month: hours of daylight have the median of the months.
  const auto median = json["daylight_hours"]["median_diffuse_illuminance"].get<double>();
  EXPECT_GT(median, 12000.0 * 1.5);
  EXPECT_LT(median, 12000.0 * 2.0);
  EXPECT_NEAR(json["daylight_factors"][0]["target_factor_percent"].get<double>(), 30000.0 / median, 1e-9);
  EXPECT_EQ(json["daylight_factors"][2]["level"], "high");
  EXPECT_EQ(json["brightest_hours"].size(), 5u);
  EXPECT_EQ(json["oddities"], Json::array());
}

TEST(WeatherCommand, reports_oddities_and_refuses_other_files) {
  const auto folder = fresh_folder("weather_odd");
  std::ofstream(folder / "west.epw") << made_epw({.written_longitude = -77.2});
  const auto run = cli::run(folder, "$LUXEL weather west.epw");
  EXPECT_EQ(run.code, 0);
  EXPECT_NE(run.out.find("one of them has the wrong sign"), std::string::npos) << run.out;
  std::ofstream(folder / "short.wea")
      << "place A_B\nlatitude 48\nlongitude -11\ntime_zone -15\nsite_elevation 5\n"
         "weather_data_file_units 1\n6 1 12.5 700 100\n";
  const auto part = cli::run(folder, "$LUXEL weather short.wea");
  EXPECT_EQ(part.code, 0) << part.err;
  EXPECT_NE(part.out.find("1 record, where a year has 8760"), std::string::npos) << part.out;
  EXPECT_NE(part.out.find("48° north, 11° east, 5 m, UTC+01:00"), std::string::npos) << part.out;
  std::ofstream(folder / "room.obj") << "v 0 0 0\n";
  const auto other = cli::run(folder, "$LUXEL weather room.obj");
  EXPECT_EQ(other.code, 1);
  EXPECT_EQ(
      other.err,
      "luxel: room.obj:1: expected a weather file, which begins with LOCATION (EPW) or place (WEA), found "
      "'v 0 0 0'\n");
  EXPECT_EQ(cli::run(folder, "$LUXEL weather none.epw").code, 1);
}

// A cube whose faces look outwards, whose backs absorb light.
std::filesystem::path folder_with_cubes() {
  const auto folder = fresh_folder("sky_cubes");
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n";
  std::ofstream(folder / "outside.obj")
      << vertices << "f 4 3 2 1\nf 6 7 8 5\nf 2 6 5 1\nf 3 7 6 2\nf 4 8 7 3\nf 1 5 8 4\n";
  std::ofstream(folder / "inside.obj")
      << vertices << "f 1 2 3 4\nf 5 8 7 6\nf 1 5 6 2\nf 2 6 7 3\nf 3 7 8 4\nf 4 8 5 1\n";
  return folder;
}

TEST(SkyBake, light_that_is_even_or_nowhere_has_no_error_from_patches) {
  const auto folder = folder_with_cubes();
  const auto even = cli::run(folder, "$LUXEL bake outside.obj --sky 1 --one-sided '*' -o even.glb");
  EXPECT_EQ(even.code, 0) << even.err;
  EXPECT_NE(even.err.find("from the size of patches 0 %, 2 % requested"), std::string::npos) << even.err;
  const auto dark = cli::run(folder, "$LUXEL bake inside.obj --sky 1 --one-sided '*' -o dark.glb");
  EXPECT_EQ(dark.code, 0) << dark.err;
  EXPECT_NE(dark.err.find("no light reaches a surface; from the size of patches 0 %"), std::string::npos)
      << dark.err;
}

}  // namespace
}  // namespace luxel::cli
