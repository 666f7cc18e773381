// SPDX-License-Identifier: Apache-2.0
// Blinds by rule and by schedule, and lamps that daylight dims, of light that is known.
#include "luxel/lighting/blinds.h"

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "luxel/core/error.h"
#include "luxel/core/output_file.h"
#include "luxel/lighting/metrics.h"
#include "luxel/patch/make_patches.h"

#include "support/open_sky.h"

namespace luxel {
namespace {

const std::string weather_text =
    "place Nowhere\nlatitude 42\nlongitude 88\ntime_zone 90\nsite_elevation 100\nweather_data_file_units 1\n"
    "1 15 10.5 0 150\n6 20 8.5 0 120\n6 20 12.5 600 120\n6 20 20.5 0 0\n";

// A point above open ground. The first group is a tenth of the sky's light, the second the rest.
struct OpenGround {
  Weather weather = read_weather(weather_text, "ours.wea");
  PatchSet patches = make_patches(truth::open_ground(), {});
  Context context;
  Tracer tracer{patches, context};
  std::vector<ProbePoint> points = {{Vec3(0, 0, 1), Vec3(0, 0, 1)}};
  DaylightCoefficients open = truth::open_sky(1, 1.0f);
  WindowLight windows{{{"a", 0.5}, {"b", 0.0}},
                      {patches, patches},
                      {truth::open_sky(1, 0.9f), truth::open_sky(1, 0.1f)},
                      0.0};
  YearSkies skies = skies_of_year(weather, open.sky, 0.2);
  DaylightYear year{{open, windows}, skies, points, {patches, tracer}, context};
  std::uint32_t all = year.replicates();
};

std::filesystem::path file(const std::string& name, const std::string& content) {
  const auto path = std::filesystem::path(testing::TempDir()) / name;
  write_file(path, content);
  return path;
}

TEST(Blinds, keep_out_their_part_of_the_light) {
  const OpenGround o;
  ASSERT_EQ(o.year.hours().size(), 3u);
  YearSchedule schedule;
  schedule.closed = {{1.0f, 0.5f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f, 1.0f}};
  const Blinds blinds(o.year, {true, true, true}, {}, schedule);
  const auto open = o.year.illuminance(o.all);
  auto light = open;
  blinds.apply(light, o.all);
  EXPECT_NEAR(light[0], open[0] * (1.0f - 0.5f * 0.1f), 1e-4f * open[0]);
  EXPECT_NEAR(light[1], open[1] * (1.0f - 0.5f * 0.5f * 0.1f - 0.9f), 1e-4f * open[1]);
  EXPECT_EQ(light[2], open[2]);
}

// The sun goes through no window here (both dark sets let it pass), so no group closes; as one group it does.
TEST(Blinds, close_where_the_sun_comes_through_their_windows) {
  const OpenGround o;
  const std::vector<bool> occupied = {true, true, true};
  const Blinds groups(o.year, occupied, {}, {});
  EXPECT_EQ(groups.closed(0), std::vector<float>(3, 0.0f));
  const auto one = all_windows(0.05);
  const DaylightYear year({o.open, one}, o.skies, o.points, {o.patches, o.tracer}, o.context);
  ASSERT_GT(year.direct_sun()[2], 1000.0f);
  EXPECT_EQ(Blinds(year, occupied, {}, {}).closed(0), (std::vector<float>{0.0f, 0.0f, 1.0f}));
  EXPECT_EQ(Blinds(year, {true, true, false}, {}, {}).closed(0), std::vector<float>(3, 0.0f));
  auto light = year.illuminance(o.all);
  const auto open = light;
  Blinds(year, occupied, {}, {}).apply(light, o.all);
  EXPECT_EQ(light[0], open[0]);
  EXPECT_NEAR(light[2], 0.05f * open[2], 1e-4f * open[2]);
}

TEST(DimmedLighting, adds_what_daylight_lacks) {
  const OpenGround o;
  const auto lux = o.year.illuminance(o.all);
  MetricOptions options;
  options.from = 0.0;
  options.to = 24.0;
  options.lighting = {.power = 400.0, .level = 2.0 * double{lux[0]}};
  options.schedule.closed = {{0.0f, 0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f, 0.0f}};
  const auto metrics = metrics_of(o.year, o.weather, options).metrics;
  const auto lacks = [&](float have) { return std::max(0.0, 1.0 - double{have} / options.lighting.level); };
  // Four hours are occupied; the last one is without light.
  const auto energy = 0.4 * (lacks(lux[0]) + lacks(lux[1]) + lacks(lux[2]) + 1.0);
  EXPECT_NEAR(metrics.lighting_energy.value, energy, 1e-6);
  EXPECT_NEAR(metrics.lighting_saved.value, 4.0 * 0.4 - energy, 1e-6);
  EXPECT_GE(energy, 0.4 * 1.5);
  ASSERT_EQ(metrics.blinds.size(), 2u);
  EXPECT_EQ(metrics.blinds[0].name, "a");
  EXPECT_EQ(metrics.blinds[0].closed_hours, 0.0);
}

TEST(Schedule, is_read_record_by_record) {
  const std::vector<WindowGroup> groups = {{"South", 0.1}, {"north", 0.1}};
  const auto schedule = read_schedule(file("both.csv", "occupied,south,blinds\n1,0.5,0\n0,1,1\n"), 2, groups);
  EXPECT_EQ(schedule.occupied, (std::vector<std::uint8_t>{1, 0}));
  ASSERT_EQ(schedule.closed.size(), 2u);
  EXPECT_EQ(schedule.closed[0], (std::vector<float>{0.5f, 1.0f}));
  EXPECT_EQ(schedule.closed[1], (std::vector<float>{0.0f, 1.0f}));
  EXPECT_TRUE(read_schedule(file("occupied.csv", "occupied\n1\n1\n"), 2, groups).closed.empty());
  const auto one = read_schedule(file("one.csv", "north\n1\n"), 1, groups);
  EXPECT_TRUE(one.occupied.empty());
  EXPECT_EQ(one.closed[0], std::vector<float>{0.0f});
}

TEST(Schedule, names_the_line_of_what_is_wrong) {
  const std::vector<WindowGroup> groups = {{"south", 0.1}};
  const auto message = [&](const std::string& content) {
    try {
      read_schedule(file("wrong.csv", content), 2, groups);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(message("occupied\n1\n0.5\n").find(":3: 'occupied' is 0.5"), std::string::npos);
  EXPECT_NE(message("south\n1\n1.5\n").find(":3: the closed part of 'south' is 1.5"), std::string::npos);
  EXPECT_NE(message("east\n1\n").find("there is no column 'east'"), std::string::npos);
  EXPECT_NE(message("south\n1\n").find("has 1 rows, the weather file 2 records"), std::string::npos);
}

}  // namespace
}  // namespace luxel
