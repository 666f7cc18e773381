// SPDX-License-Identifier: Apache-2.0
// Intervals of means over the points of a year: how often they hold the mean of all other runs.
//
// Risk. The seeds are fixed. With others, an interval that holds the truth in exactly 95 % of the runs would
// leave it out 15 times of 100 or more with a chance of 2e-4, and the scatter of 100 runs would exceed the
// stated error by 0.3 of it with one of 3e-5. An interval that is 1.5 times too small fails the second check
// with a chance of 0.99. Numbers that count hours over a limit jump, and so are not among them.
#include <cmath>
#include <functional>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "luxel/core/student.h"
#include "luxel/lighting/daylight_factor.h"
#include "luxel/lighting/daylight_scene.h"
#include "luxel/lighting/metrics.h"
#include "luxel/lighting/year.h"
#include "luxel/patch/make_patches.h"

#include "support/stored_run.h"
#include "support/window_rooms.h"

namespace luxel {
namespace {

constexpr int runs = 100;
constexpr double albedo = 0.2;

// Ten hours of the 21st of four months, overcast to clear.
std::string some_weather() {
  std::string text =
      "place Nowhere\nlatitude 42\nlongitude 88\ntime_zone 90\nsite_elevation 100\n"
      "weather_data_file_units 1\n";
  int i = 0;
  for (const int month : {3, 6, 9, 12})
    for (int hour = 8; hour < 18; ++hour, ++i)
      text += fmt::format("{} 21 {}.5 {} {}\n", month, hour, 250 * (i % 3), 60 + 35 * (i % 4));
  return text;
}

std::vector<ProbePoint> nine_points() {
  std::vector<ProbePoint> points;
  for (const float y : {0.4f, 1.0f, 1.6f})
    for (const float x : {0.4f, 1.0f, 1.6f}) points.push_back({Vec3(x, y, 0.3f), Vec3(0, 0, 1)});
  return points;
}

struct Quantity {
  const char* name;
  std::function<Figure(const DaylightFactors&, const YearReport&)> of;
  std::vector<Figure> found;

  void judge() const {
    double sum = 0.0, squares = 0.0, stated = 0.0;
    for (const auto& f : found) sum += f.value;
    const auto n = static_cast<double>(found.size());
    int outside = 0;
    for (const auto& f : found) {
      const auto others = (sum - f.value) / (n - 1.0);
      const auto half = 0.5 * (f.high - f.low);
      if (std::abs(f.value - others) > half * std::sqrt(n / (n - 1.0))) ++outside;
      squares += (f.value - sum / n) * (f.value - sum / n) / (n - 1.0);
      const auto error = half / (1.96 * student_widening(7.0));
      stated += error * error / n;
    }
    EXPECT_LT(outside, 15) << name << ": of " << n;
    EXPECT_LT(std::sqrt(squares / stated), 1.3) << name << ": scatter over stated error";
    EXPECT_GT(std::sqrt(squares / stated), 0.5) << name << ": scatter over stated error";
    testing::Test::RecordProperty(name,
                                  fmt::format("{} outside, {:.3f}", outside, std::sqrt(squares / stated)));
  }
};

TEST(DaylightYearStatistics, intervals_of_means_over_points_hold_the_truth) {
  const auto weather = read_weather(some_weather(), "ours.wea");
  const SkyPatches sky(1, {0, 0, 1}, {0, 1, 0});
  const auto skies = skies_of_year(weather, sky, albedo);
  auto scene = truth::window_room().scene();
  set_only_sky(sky, mean_sky(skies), scene);
  auto patches = make_patches(scene, {.max_edge = 1.0f});
  patches.portals = truth::window_portals();
  const Context context;
  const Tracer tracer(patches, context);
  const auto points = nine_points();
  const auto windows = all_windows(0.05);
  std::vector<Quantity> quantities = {
      {"daylight_factor", [](const auto& f, const auto&) { return f.mean; }, {}},
      {"median_factor", [](const auto& f, const auto&) { return f.median; }, {}},
      {"continuous", [](const auto&, const auto& y) { return y.metrics.continuous_autonomy.mean; }, {}},
      {"exposure", [](const auto&, const auto& y) { return y.metrics.exposure.mean; }, {}}};
  for (int run = 0; run < runs; ++run) {
    SampledOptions options;
    options.error = 0.2;
    options.error_measure = ErrorMeasure::power;
    options.seed = static_cast<std::uint64_t>(run + 1);
    const auto state = truth::stored_run(patches, tracer, options, context).state;
    const auto coefficients = find_coefficients({patches, *state, options}, tracer, points,
                                                {.rays = 256, .seed = options.seed}, context);
    const DaylightYear year({coefficients, windows}, skies, coefficients.origins,
                            {patches, tracer, options.seed}, context);
    const auto factors = daylight_factors(coefficients, 16, albedo);
    const auto report = metrics_of(year, weather, {});
    for (auto& q : quantities) q.found.push_back(q.of(factors, report));
  }
  for (const auto& q : quantities) q.judge();
}

}  // namespace
}  // namespace luxel
