// SPDX-License-Identifier: Apache-2.0
// Daylight coefficients against closed forms, and a year from them against solves of single hours.
//
// Risk. Seeds are fixed. Numbers with noise are compared within six of their standard errors; with other
// random numbers one of the some thirty would fail with a chance below one in a thousand.
#include <cmath>
#include <numbers>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "luxel/import/set_daylight.h"
#include "luxel/lighting/daylight_factor.h"
#include "luxel/lighting/daylight_scene.h"
#include "luxel/lighting/metrics.h"
#include "luxel/lighting/year.h"
#include "luxel/patch/make_patches.h"
#include "luxel/photometry/sky_integrals.h"
#include "luxel/render/probe_light.h"
#include "luxel/solve/sampled.h"

#include "support/axes.h"
#include "support/stored_run.h"
#include "support/window_rooms.h"

namespace luxel {
namespace {

using test::up;

constexpr double sigmas = 6.0, albedo = 0.2;
const Vec3d zenith(0, 0, 1), north(0, 1, 0);

const std::vector<ProbePoint> points = {
    {{1.0f, 0.6f, 0.4f}, up}, {{0.4f, 1.5f, 0.3f}, up}, {{1.7f, 1.7f, 0.2f}, up}};

// Points of window_room(): a room whose window is a hole in the wall y = 0.
struct Solved {
  PatchSet patches;
  Context context;
  Tracer tracer;
  std::shared_ptr<const SampleState> state;
  SampledOptions options;

  Solved(const SkyPatches& sky, const std::vector<double>& luminance)
      : patches(made(sky, luminance)), tracer(patches, context) {
    options.error = 0.02;
    options.ray_budget = 4'000'000;
    options.error_measure = ErrorMeasure::power;
    state = truth::stored_run(patches, tracer, options, context).state;
  }

  DaylightCoefficients coefficients(std::uint32_t rays = 32768) const {
    return find_coefficients({patches, *state, options}, tracer, points, {.rays = rays, .seed = 1}, context);
  }

 private:
  static PatchSet made(const SkyPatches& sky, const std::vector<double>& luminance) {
    auto scene = truth::window_room().scene();
    set_only_sky(sky, luminance, scene);
    auto patches = make_patches(scene, {.max_edge = 0.5f});
    patches.portals = truth::window_portals();
    return patches;
  }
};

std::vector<double> overcast(const SkyPatches& sky) {
  return sky_patch_luminances(SkyModel::cie(16), sky, 10'000.0, albedo);
}

// The light of a scene at the points by a separate solve.
std::vector<ProbedLight> probed(const Daylight& daylight) {
  auto scene = truth::window_room().scene();
  set_daylight(daylight, up, scene);
  auto patches = make_patches(scene, {.max_edge = 0.5f});
  patches.portals = truth::window_portals();
  const Context context;
  const Tracer tracer(patches, context);
  Solution solution;
  solve_sampled(patches, tracer, solution, {.error = 0.005, .error_measure = ErrorMeasure::power}, context);
  const SolutionProbe probe(patches, solution, tracer, nullptr, context);
  return probe_light(probe, points, {.error = 0.003, .max_rays = 1u << 20}, context);
}

TEST(DaylightCoefficients, give_the_daylight_factors_of_a_solve_of_the_overcast_sky) {
  const SkyPatches sky(2, zenith, north);
  const Solved solved(sky, overcast(sky));
  const auto factors = daylight_factors(solved.coefficients(), 16, albedo);
  Daylight daylight;
  daylight.sky = Daylight::Sky::cie;
  const auto truth = probed(daylight);
  for (std::size_t m = 0; m < points.size(); ++m) {
    const auto expected = truth[m].illuminance / daylight.illuminance;
    const auto error =
        std::hypot(double{factors.standard_error[m]}, truth[m].standard_error() / daylight.illuminance);
    EXPECT_NEAR(double{factors.value[m]}, expected, sigmas * error + 0.002 * expected) << m;
    EXPECT_LT(double{factors.standard_error[m]}, 0.04 * expected);
    double sum = 0.0;
    for (const auto& part : factors.components) sum += double{part[m]};
    EXPECT_NEAR(sum, double{factors.value[m]}, 1e-6);
    EXPECT_EQ(factors.components[1][m], 0.0f) << "there is nothing outside, and the points face up";
  }
  EXPECT_LE(factors.min.low, factors.min.value);
  EXPECT_NEAR(factors.mean.value, (factors.value[0] + factors.value[1] + factors.value[2]) / 3.0, 1e-6);
}

// Without reflections the sky component is the closed form: see daylight_test.cpp.
TEST(DaylightCoefficients, in_a_black_box_are_the_sky_component) {
  truth::SceneBuilder b;
  b.material("black", 0.0f, 0.0f);
  constexpr float low = -2.0f, high = 4.0f;
  const auto at = [](float u, float v) { return Vec3(u, 0.0f, v); };
  b.quad(at(low, low), at(high, low), at(high, 0), at(low, 0))
      .quad(at(low, 1), at(high, 1), at(high, high), at(low, high));
  b.quad(at(low, 0), at(0, 0), at(0, 1), at(low, 1)).quad(at(1, 0), at(high, 0), at(high, 1), at(1, 1));
  b.quad({low, 3, low}, {high, 3, low}, {high, 3, high}, {low, 3, high});
  b.quad({low, 0, high}, {low, 3, high}, {high, 3, high}, {high, 0, high});
  b.quad({low, 0, low}, {low, 3, low}, {low, 3, high}, {low, 0, high});
  b.quad({high, 0, low}, {high, 0, high}, {high, 3, high}, {high, 3, low});
  b.quad({low, 0, low}, {high, 0, low}, {high, 3, low}, {low, 3, low});
  const SkyPatches sky(4, zenith, north);
  auto scene = b.scene();
  set_only_sky(sky, overcast(sky), scene);
  auto patches = make_patches(scene, {.max_edge = no_max_edge});
  patches.portals = {{{Vec3(0, 0, 0), Vec3(0, 0, 1), Vec3(1, 0, 1)}, false},
                     {{Vec3(0, 0, 0), Vec3(1, 0, 1), Vec3(1, 0, 0)}, false}};
  const Context context;
  const Tracer tracer(patches, context);
  Solution solution;
  std::shared_ptr<const SampleState> state;
  const SampledOptions options{.error = 0.05, .error_measure = ErrorMeasure::power};
  const SolveHooks hooks{.from = {},
                         .keep = [&](std::shared_ptr<const SampleState> s) { state = std::move(s); },
                         .on_light = {}};
  solve_sampled(patches, tracer, solution, options, hooks, context);
  const std::vector<ProbePoint> point = {{{0.0f, 1.0f, 0.0f}, up}};
  const auto found =
      find_coefficients({patches, *state, options}, tracer, point, {.rays = 1u << 18, .seed = 1}, context);
  const auto factors = daylight_factors(found, 16, 0.0);
  EXPECT_NEAR(double{factors.value[0]}, 0.04525138, sigmas * double{factors.standard_error[0]} + 5e-5);
  EXPECT_LT(double{factors.standard_error[0]}, 0.001);
}

// Three hours of a weather file of ours: a cloudy one, one with low sun into the window, one with the sun
// behind the room.
const std::string weather_text =
    "place Nowhere\nlatitude 42\nlongitude 88\ntime_zone 90\nsite_elevation 100\nweather_data_file_units 1\n"
    "1 15 10.5 20 150\n1 15 12.5 700 110\n6 20 8.5 600 120\n";

TEST(DaylightYear, has_the_light_of_solves_of_its_hours) {
  const auto weather = read_weather(weather_text, "ours.wea");
  ASSERT_EQ(weather.hours.size(), 3u);
  const SkyPatches sky(2, zenith, north);
  const auto skies = skies_of_year(weather, sky, albedo);
  const Solved solved(sky, mean_sky(skies));
  const auto coefficients = solved.coefficients();
  const auto windows = all_windows(0.05);
  const DaylightYear year({coefficients, windows}, skies, points, {solved.patches, solved.tracer},
                          solved.context);
  ASSERT_EQ(year.hours().size(), 3u);
  const auto light = year.illuminance(year.replicates());
  for (std::size_t h = 0; h < 3; ++h) {
    const auto& hour = year.hours()[h];
    const auto perez = perez_sky(weather, h, hour.sun);
    Daylight daylight;
    daylight.sky = Daylight::Sky::perez;
    daylight.illuminance = 0.0;
    daylight.direct_normal = *weather.hours[h].direct_normal;
    daylight.diffuse_horizontal = *weather.hours[h].diffuse_horizontal;
    daylight.dew_point = mean_dew_point(weather, h);
    daylight.orbit_factor = hour.sun.orbit_factor();
    daylight.sun = Daylight::Sun{hour.sun.elevation, hour.sun.azimuth};
    EXPECT_NEAR(hour.sky_illuminance, perez.diffuse_illuminance, 1e-9);
    const auto truth = probed(daylight);
    for (std::size_t m = 0; m < points.size(); ++m) {
      const auto expected = truth[m].illuminance;
      // Reflected sunlight comes from four patches of 577 in place of the disc: measured at most 3 %.
      EXPECT_NEAR(double{light[h * points.size() + m]}, expected,
                  sigmas * truth[m].standard_error() + 0.03 * expected)
          << "hour " << h << ", point " << m;
    }
  }
}

TEST(DaylightYear, counts_what_its_definitions_say) {
  const auto weather = read_weather(weather_text, "ours.wea");
  const SkyPatches sky(1, zenith, north);
  const auto skies = skies_of_year(weather, sky, albedo);
  const Solved solved(sky, mean_sky(skies));
  const auto coefficients = solved.coefficients(4096);
  const auto windows = all_windows(0.05);
  const DaylightYear year({coefficients, windows}, skies, points, {solved.patches, solved.tracer},
                          solved.context);
  const auto light = year.illuminance(year.replicates());
  const auto report = metrics_of(year, weather, {});
  const auto& m = report.metrics;
  EXPECT_EQ(m.occupied, 3u);
  for (std::size_t p = 0; p < points.size(); ++p) {
    double autonomy = 0.0, part = 0.0, useful = 0.0, exposure = 0.0, sun = 0.0;
    for (std::size_t h = 0; h < 3; ++h) {
      const double lux = light[h * points.size() + p];
      autonomy += lux >= 300.0 ? 1.0 / 3.0 : 0.0;
      part += std::min(1.0, lux / 300.0) / 3.0;
      useful += lux >= 100.0 && lux <= 3000.0 ? 1.0 / 3.0 : 0.0;
      exposure += lux;
      sun += year.direct_sun()[h * points.size() + p] > 1000.0f ? 1.0 : 0.0;
    }
    EXPECT_NEAR(double{m.autonomy.value[p]}, autonomy, 1e-6);
    EXPECT_NEAR(double{m.continuous_autonomy.value[p]}, part, 1e-5);
    EXPECT_NEAR(double{m.useful.value[p]}, useful, 1e-6);
    EXPECT_NEAR(double{m.below_100.value[p]} + double{m.useful.value[p]} + double{m.above_3000.value[p]}, 1.0,
                1e-6);
    EXPECT_NEAR(double{m.exposure.value[p]}, exposure, 1e-5 * exposure);
    EXPECT_EQ(double{m.sun_hours.value[p]}, sun);
  }
  EXPECT_EQ(m.sun_exposure.value, 0.0);  // 250 hours are needed
  EXPECT_EQ(report.daylight_hours, 1u);  // half of three, the brightest of the diffuse ones
}

}  // namespace
}  // namespace luxel
