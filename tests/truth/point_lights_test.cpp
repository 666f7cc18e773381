// SPDX-License-Identifier: Apache-2.0
// Lamps without a surface against closed forms: the inverse square law, power in a closed room, spots, the
// sun; and the solver against paths.
//
// Risk. Seeds are fixed. Numbers with noise are compared within six of their standard errors; with other
// random numbers one of the some hundred would fail with a chance below one in a million.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "luxel/core/error.h"
#include "luxel/patch/light_groups.h"
#include "luxel/patch/make_patches.h"
#include "luxel/render/path_traced.h"
#include "luxel/solve/sampled.h"
#include "luxel/solve/solve_light.h"
#include "luxel/trace/point_sight.h"

#include "support/truth_scenes.h"

namespace luxel {
namespace {

constexpr auto pi_d = std::numbers::pi;

Scene black_floor() {
  truth::SceneBuilder builder;
  builder.material("floor", 0.0f, 0.0f).quad({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0});
  return builder.scene();
}

PointLight lamp_at(const Vec3& place) {
  return {.name = "lamp", .position = place, .intensity = Vec3(2.0f, 1.0f, 0.5f)};
}

struct Answer {
  PatchSet patches;
  Solution light;
  SolveReport report;
};
Answer solved(const Scene& scene, float edge, double error = 0.01) {
  Answer a;
  check_scene(scene);
  a.patches = make_patches(scene, {.max_edge = edge});
  const Context context(2);
  const Tracer tracer(a.patches, context);
  a.report = solve_sampled(a.patches, tracer, a.light, {.error = error, .error_measure = ErrorMeasure::power},
                           context);
  return a;
}

// Of a patch of the plane z = 0, by its red band.
double exact_mean(const Answer& a, std::size_t p, const PointLight& lamp) {
  constexpr int steps = 64;
  const auto corners = a.patches.points(p);
  double sum = 0.0;
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j) {
      // The middles of four times as many small triangles: both ways round.
      const bool flipped = i + j >= steps;
      const auto u = (i + 1.0 / 3.0) / steps, v = (j + 1.0 / 3.0) / steps;
      const auto s = flipped ? 1.0 - u : u, t = flipped ? 1.0 - v : v;
      const auto x = (1.0 - s - t) * Vec3d(corners[0]) + s * Vec3d(corners[1]) + t * Vec3d(corners[2]);
      sum += double{lamp.intensity.r} * sight_of(lamp, x, {0, 0, 1}).irradiance;
    }
  return sum / (steps * steps);
}

TEST(PointLights, FollowTheInverseSquareLaw) {
  auto scene = black_floor();
  scene.point_lights = {lamp_at({0.3f, 0.2f, 0.5f})};
  const auto a = solved(scene, 0.5f, 0.003);
  for (std::size_t p = 0; p < a.patches.size(); ++p) {
    const auto exact = exact_mean(a, p, scene.point_lights[0]);
    EXPECT_NEAR(a.light.irradiance.front[3 * p], exact,
                6.0 * a.light.standard_error.front[3 * p] + 1e-4 * exact);
    EXPECT_NEAR(a.light.irradiance.front[3 * p + 2], 0.25 * a.light.irradiance.front[3 * p], 1e-5);
    EXPECT_EQ(a.light.irradiance.back[3 * p], 0.0f);
  }
}

TEST(PointLights, InTheSunAllIsAlikeAndLevel) {
  auto scene = black_floor();
  const auto down = glm::normalize(Vec3(1.0f, 0.0f, -2.0f));
  scene.point_lights = {
      {.name = "sun", .kind = PointLightKind::directional, .direction = down, .intensity = Vec3(3.0f)}};
  const auto a = solved(scene, 0.5f);
  for (std::size_t p = 0; p < a.patches.size(); ++p)
    EXPECT_NEAR(a.light.irradiance.front[3 * p], 3.0 * 2.0 / std::sqrt(5.0), 1e-5);
}

// A floor of 4 m² under a sun of 3 W/m², half of it shaded by a black screen.
TEST(PointLights, OfTheSunCountsInTheEnergyBalance) {
  truth::SceneBuilder builder;
  builder.material("floor", 0.5f, 0.0f).quad({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0});
  builder.material("screen", 0.0f, 0.0f, false).quad({-1, 0, 1}, {-1, 1, 1}, {1, 1, 1}, {1, 0, 1});
  auto scene = builder.scene();
  scene.point_lights = {
      {.name = "sun", .kind = PointLightKind::directional, .direction = {0, 0, -1}, .intensity = Vec3(3.0f)}};
  const auto a = solved(scene, 0.25f, 0.003);
  const auto& energy = a.report.energy;
  EXPECT_EQ(energy.emitted[0], 0.0);
  // The screen's front faces down; the sun meets its absorbing back, which does not count.
  EXPECT_NEAR(energy.from_sky[0], 3.0 * 2.0, 0.01);
  const auto sum = energy.absorbed[0] + energy.escaped[0] + energy.lost_at_backs[0] + energy.unshot[0];
  EXPECT_NEAR(sum, energy.from_sky[0], 0.03 * sum);
  // Paths find the same.
  const Context context(2);
  const Tracer tracer(a.patches, context);
  Solution paths;
  const auto traced = trace_light(a.patches, tracer, paths, {.limits = {.error = 0.02}}, context);
  EXPECT_EQ(traced.from_sky, energy.from_sky);
}

// All power of a lamp in a closed room is absorbed, wherever it stands.
TEST(PointLights, GiveAClosedRoomTheirPower) {
  auto scene =
      truth::cube({{{0.5f, 0.0f}, {0.7f, 0.0f}, {0.2f, 0.0f}, {0.2f, 0.0f}, {0.6f, 0.0f}, {0.6f, 0.0f}}});
  for (const auto kind : {PointLightKind::point, PointLightKind::spot}) {
    auto lamp = lamp_at({0.4f, 0.3f, 0.7f});
    lamp.kind = kind;
    lamp.direction = glm::normalize(Vec3(0.2f, 0.1f, -1.0f));
    lamp.cos_inner = 0.9f;
    lamp.cos_outer = 0.6f;
    scene.point_lights = {lamp};
    const auto a = solved(scene, 0.25f);
    const auto power =
        2.0 * (kind == PointLightKind::point ? 4.0 * pi_d : 2.0 * pi_d * ((1.0 - 0.9) + (0.9 - 0.6) / 3.0));
    double absorbed = 0.0, squared_noise = 0.0;
    for (std::size_t p = 0; p < a.patches.size(); ++p) {
      const auto fraction = double{a.patches.area[p]} * (1.0 - double{a.patches.reflectance(p, 0)});
      absorbed += fraction * double{a.light.irradiance.front[3 * p]};
      squared_noise += std::pow(fraction * double{a.light.standard_error.front[3 * p]}, 2);
    }
    // Errors of patches are correlated by reflected light: their sum over a few is an upper bound.
    EXPECT_NEAR(absorbed, power, 6.0 * 3.0 * std::sqrt(squared_noise)) << static_cast<int>(kind);
    EXPECT_NEAR(a.report.energy.emitted[0], power, 1e-5 * power);
  }
}

TEST(PointLights, AreSeenByPathsAlike) {
  auto scene =
      truth::cube({{{0.5f, 0.0f}, {0.5f, 1.0f}, {0.5f, 0.0f}, {0.5f, 0.0f}, {0.5f, 0.0f}, {0.5f, 0.0f}}});
  scene.point_lights = {lamp_at({0.5f, 0.5f, 0.4f}), lamp_at({0.2f, 0.8f, 0.6f})};
  scene.point_lights[1].kind = PointLightKind::spot;
  scene.point_lights[1].direction = {1, 0, 0};
  scene.point_lights[1].name = "spot";
  const auto a = solved(scene, 0.5f, 0.005);
  const Context context(2);
  const Tracer tracer(a.patches, context);
  Solution paths;
  trace_light(a.patches, tracer, paths, {.limits = {.error = 0.01}, .bounces_from = BouncesFrom::patches},
              context);
  for (std::size_t i = 0; i < paths.irradiance.front.size(); ++i)
    EXPECT_NEAR(a.light.irradiance.front[i], paths.irradiance.front[i],
                6.0 * std::hypot(a.light.standard_error.front[i], paths.standard_error.front[i]));
}

TEST(PointLights, AreLightGroups) {
  auto scene = black_floor();
  scene.point_lights = {lamp_at({0, 0, 1}), lamp_at({0, 1, 1})};
  scene.point_lights[1].name = "desk lamp";
  auto patches = make_patches(scene, {.max_edge = 1.0f});
  set_light_groups(scene, std::vector<LightGroupRule>{{"desk", "desk*"}}, patches);
  EXPECT_EQ(patches.light_groups, (std::vector<std::string>{"lamp", "desk"}));
  EXPECT_EQ(patches.point_lights[1].light_group, 1u);
}

TEST(PointLights, AreRefusedByMethodsThatDoNotKnowThem) {
  auto scene = black_floor();
  scene.point_lights = {lamp_at({0, 0, 1})};
  const auto patches = make_patches(scene, {.max_edge = 1.0f});
  const Context context(1);
  const Tracer tracer(patches, context);
  Solution light;
  try {
    solve_light(patches, tracer, light, {.method = Method::shooting}, context);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("lamp 'lamp' has no surface"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace luxel
