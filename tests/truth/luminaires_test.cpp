// SPDX-License-Identifier: Apache-2.0
// Luminaires against closed forms: far from the opening, on the axis of a disk, the power in a closed room;
// the solver against paths, and sampling of many luminaires against their sum. cie171_lamps_test.cpp has the
// cases of CIE 171, luminaire_turns_test.cpp turned, divided and converted luminaires.
//
// Risk. Seeds are fixed. Closed forms: see support/three_errors.h; other numbers with noise are compared
// within six of their standard errors.
#include "support/luminaires.h"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "luxel/core/sobol.h"
#include "luxel/lamps/punctual_choices.h"
#include "luxel/patch/make_patches.h"
#include "luxel/render/path_traced.h"
#include "luxel/solve/sampled.h"
#include "luxel/trace/point_sight.h"

#include "support/axes.h"
#include "support/probe_rig.h"
#include "support/three_errors.h"
#include "support/truth_scenes.h"

namespace luxel {
namespace {

using test::cosine_distribution;
using test::expect_truth;
using test::lopsided_distribution;
using test::luminaire;
using test::ProbeRig;
using test::up;
using test::WithError;

constexpr LuminousOpening point_opening{};

Scene black_room() {
  truth::SceneBuilder b;
  test::add_room(b, {0, 0, 0}, {4, 4, 3}, 0.0f);
  return b.scene();
}

// Far away, an opening of any shape gives what a point gives.
TEST(LuminaireOpening, is_a_point_from_far_away) {
  truth::SceneBuilder b;
  b.material("floor", 0.0f, 0.0f).quad({-9, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-9, 9, 0});
  for (const auto shape :
       {OpeningShape::rectangle, OpeningShape::ellipse, OpeningShape::box, OpeningShape::vertical_cylinder,
        OpeningShape::cylinder_along_x, OpeningShape::ellipsoid}) {
    auto scene = b.scene();
    scene.point_lights = {luminaire(lopsided_distribution(), {shape, {0.03, 0.02, 0.01}}, {1, 2, 4})};
    const ProbeRig wide(scene, no_max_edge, 0.0f);
    scene.point_lights[0] = luminaire(lopsided_distribution(), point_opening, {1, 2, 4});
    const ProbeRig narrow(scene, no_max_edge, 0.0f);
    for (const auto& at : {Vec3(5, 4, 0), Vec3(-3, 0, 0), Vec3(4, -2, 0)}) {
      const auto by_opening = wide.at(at, up, {.error = 0.0005, .max_rays = 1u << 18});
      const auto by_point = narrow.at(at, up).illuminance;
      EXPECT_NEAR(by_opening.illuminance, by_point, 1e-3 * by_point + 6.0 * by_opening.sampling_error);
    }
  }
}

// On the axis of an even disk E / E of a point = d² / (d² + R²).
TEST(LuminaireOpening, of_a_disk_has_the_closed_form_on_its_axis) {
  auto scene = black_room();
  scene.point_lights = {
      luminaire(cosine_distribution(1000.0), {OpeningShape::ellipse, {0.8, 0.8, 0}}, {2, 2, 2.5f})};
  const ProbeRig rig(scene, no_max_edge, 0.0f);
  for (const double d : {0.2, 0.5, 1.0, 2.0}) {
    const auto exact = 1000.0 / (d * d + 0.16);
    const auto measure = [&, d = d](std::uint64_t seed) {
      const auto light = rig.at({2, 2, 2.5f - static_cast<float>(d)}, up,
                                {.error = 0.0005, .max_rays = 1u << 20, .seed = seed});
      return WithError{light.illuminance, light.sampling_error};
    };
    expect_truth(measure, exact, 5e-5 * exact, fmt::format("{} m", d));
  }
}

struct Solved {
  PatchSet patches;
  Solution light;
  SolveReport report;
};
Solved solve(const Scene& scene, float edge, double error, std::uint64_t seed = 1) {
  Solved s;
  check_scene(scene);
  s.patches = make_patches(scene, {.max_edge = edge});
  const Context context(2);
  const Tracer tracer(s.patches, context);
  s.report = solve_sampled(s.patches, tracer, s.light,
                           {.error = error, .error_measure = ErrorMeasure::power, .seed = seed}, context);
  return s;
}

Scene closed_room(float reflectance) {
  return truth::cube({{{reflectance, 0.0f},
                       {reflectance, 0.0f},
                       {reflectance, 0.0f},
                       {reflectance, 0.0f},
                       {reflectance, 0.0f},
                       {reflectance, 0.0f}}},
                     2.0f);
}

// The mean over all faces of the total irradiance of a closed room of even reflectance is power / (area (1 -
// reflectance)), with the linear flux, which is what the scene receives.
TEST(Luminaire, gives_a_closed_room_its_linear_flux) {
  for (const auto& opening : {point_opening, LuminousOpening{OpeningShape::box, {0.4, 0.2, 0.1}}}) {
    auto scene = closed_room(0.5f);
    scene.point_lights = {luminaire(lopsided_distribution(), opening, {0.9f, 1.1f, 1.3f})};
    const auto& intensity = scene.point_lights[0].photometry->intensity;
    const auto watts = intensity.linear_flux() / luminous_efficacy;
    const auto measure = [&](std::uint64_t seed) {
      const auto s = solve(scene, 0.5f, 0.002, seed);
      EXPECT_NEAR(s.report.energy.emitted[0], watts, 1e-5 * watts);
      const auto& all = s.report.means.received;
      return WithError{all.power[0] / 24.0, all.standard_error[0] / 24.0};
    };
    expect_truth(measure, watts / (24.0 * 0.5), 1e-5 * watts, "mean irradiance");
  }
}

TEST(Luminaire, is_seen_by_paths_alike) {
  auto scene = closed_room(0.6f);
  for (int i = 0; i < 12; ++i) {
    auto light = luminaire(lopsided_distribution(), {OpeningShape::rectangle, {0.3, 0.1, 0}},
                           {0.3f + 0.12f * static_cast<float>(i), 0.4f + 0.1f * static_cast<float>(i), 1.7f});
    if (i % 3 == 1) std::swap(light.local_x, light.local_y);
    light.intensity *= 0.2f + 0.1f * static_cast<float>(i);
    scene.point_lights.push_back(light);
  }
  const auto s = solve(scene, 1.0f, 0.003);
  const Context context(2);
  const Tracer tracer(s.patches, context);
  Solution paths;
  trace_light(s.patches, tracer, paths, {.limits = {.error = 0.02}, .bounces_from = BouncesFrom::patches},
              context);
  for (std::size_t i = 0; i < paths.irradiance.front.size(); ++i)
    EXPECT_NEAR(s.light.irradiance.front[i], paths.irradiance.front[i],
                6.0 * std::hypot(s.light.standard_error.front[i], paths.standard_error.front[i]));
}

// Many luminaires: the mean of single choices is the sum over all of them.
TEST(PunctualChoices, have_the_sum_over_all_lights_as_their_mean) {
  std::vector<BandPointLight> lights;
  std::vector<double> weights;
  std::vector<std::uint32_t> all;
  const OwenSobol places(3);
  for (std::uint32_t i = 0; i < 60; ++i) {
    const auto u = places.first4(i);
    auto light =
        luminaire(lopsided_distribution(), point_opening, {10 * u[0] - 5, 10 * u[1] - 5, 3 * u[2] - 1});
    light.intensity *= 0.1f + u[3];
    lights.push_back({light, {light.intensity.r}, 0});
    weights.push_back(double{light.intensity.r});
    all.push_back(i);
  }
  const Vec3d normal = glm::normalize(Vec3d(0.2, -0.1, 1.0)), point(0.3, -0.2, 0.1);
  double sum = 0.0;
  for (const auto& light : lights)
    sum += double{light.intensity[0]} * sight_of(light.light, point, normal).irradiance;
  PunctualChoices choices;
  choices.make(lights, weights, all, {point + Vec3d(0.1, 0.0, -0.02), 0.2, normal});
  constexpr std::uint32_t count = 1u << 15;
  const OwenSobol numbers(5);
  double mean = 0.0;
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto sample = choices.sample(point, normal, double{numbers.at(i, 0)}, {0.5, 0.5});
    mean += sample.given * weights[sample.light] / count;
  }
  EXPECT_NEAR(mean, sum, 2e-3 * sum);
}

}  // namespace
}  // namespace luxel
