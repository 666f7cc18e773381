// SPDX-License-Identifier: Apache-2.0
// Probes against closed forms: furnace, sky, lamps, suns, portals.
//
// Risk. Seeds are fixed. Numbers with noise are compared within six of their standard errors, which are
// widened for eight replicates; with other random numbers one of the some fifty would fail with a chance
// below one in a thousand.
#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "luxel/core/error.h"
#include "luxel/render/probe_light.h"

#include "support/axes.h"
#include "support/probe_rig.h"
#include "support/window_rooms.h"

namespace luxel {
namespace {

using test::down;
using test::east;
using test::lux;
using test::ProbeRig;
using test::up;
using truth::SceneBuilder;

constexpr double sigmas = 6.0;
constexpr double pi_d = std::numbers::pi;

void expect_near(const ProbedLight& light, double truth_lux, double rounding = 1e-5) {
  EXPECT_NEAR(light.illuminance, truth_lux, sigmas * light.sampling_error + rounding * truth_lux);
  EXPECT_NEAR(lux(light.irradiance[1]), light.illuminance, 1e-6 * truth_lux) << "grey light";
}

// Form factor from a horizontal element to a rectangle a x b in a parallel plane at distance c, one corner of
// which is straight above the element (Siegel and Howell, configuration factor B-3).
double corner_factor(double a, double b, double c) {
  const auto x = a / c, y = b / c;
  const auto rx = std::sqrt(1.0 + x * x), ry = std::sqrt(1.0 + y * y);
  return (x / rx * std::atan(y / rx) + y / ry * std::atan(x / ry)) / (2.0 * pi_d);
}

// Any rectangle [x0, x1] x [y0, y1], counted from the element.
double factor(double x0, double x1, double y0, double y1, double c) {
  const auto corner = [&](double x, double y) {
    return std::copysign(corner_factor(std::abs(x), std::abs(y), c), x * y);
  };
  return corner(x1, y1) - corner(x0, y1) - corner(x1, y0) + corner(x0, y0);
}

TEST(ProbeTruth, a_closed_furnace_gives_every_probe_the_exact_light) {
  const ProbeRig rig(truth::furnace({0.3f, 0.5f, 0.8f}, {0.6f, 0.4f, 0.2f}), 0.25f, 1.0f);
  for (const auto& at : {Vec3(0.1f, 0.2f, 0.9f), Vec3(0.45f, 0.45f, 0.1f), Vec3(0.7f, 0.7f, 0.5f)})
    for (const auto& normal : {up, down, east, Vec3(-1, 2, 0.5f)}) {
      const auto light = rig.at(at, normal, {.error = 0.01});
      EXPECT_NEAR(light.illuminance, lux(1.0), sigmas * light.sampling_error + 1e-4);
      EXPECT_LE(light.sampling_error, 0.01 * light.illuminance);
      EXPECT_TRUE(light.reached);
      for (const auto h : light.irradiance) EXPECT_NEAR(h, 1.0, 0.08);
      EXPECT_EQ(light.place, ProbePlace::free);
    }
}

// All that arrives was reflected with the same brightness, so no ray differs from another.
TEST(ProbeTruth, even_indirect_light_has_no_noise) {
  SceneBuilder b;
  test::add_room(b, {0, 0, 0}, {4, 3, 2}, 0.6f);
  const ProbeRig rig(b.scene(), 1.0f, 10.0f);
  const auto light = rig.at({1, 2, 0.5f}, {1, 1, 1});
  EXPECT_NEAR(light.illuminance, lux(6.0), 1e-4);
  EXPECT_LT(light.sampling_error, 1e-4);
  EXPECT_TRUE(light.reached);
}

TEST(ProbeTruth, an_even_sky_over_an_open_plate) {
  SceneBuilder b;
  b.material("plate", 0.0f, 0.0f)
      .quad({-3000, -3000, 0}, {3000, -3000, 0}, {3000, 3000, 0}, {-3000, 3000, 0});
  const ProbeRig rig(truth::under_sky(b, 2.0f), no_max_edge, 0.0f);
  const auto on = rig.at({0, 0, 0}, up), above = rig.at({0.3f, 0.2f, 1}, up), wall = rig.at({0, 0, 1}, east),
             below = rig.at({0, 0, 1}, down);
  EXPECT_NEAR(on.illuminance, lux(2.0 * pi_d), 0.01);
  EXPECT_EQ(on.place, ProbePlace::surface);
  EXPECT_NEAR(above.illuminance, lux(2.0 * pi_d), 0.01);
  expect_near(wall, lux(pi_d), 1e-3);
  EXPECT_NEAR(below.illuminance, 0.0, 1e-9);
  EXPECT_EQ(below.place, ProbePlace::dark);
}

// A square lamp of 1 x 1 m, 2 m above a black floor.
class UnderASquareLamp : public testing::Test {
 protected:
  static Scene scene(bool has_screen = false) {
    SceneBuilder b;
    b.material("lamp", 0.0f, 100.0f)
        .quad({-0.5f, 0.5f, 2}, {0.5f, 0.5f, 2}, {0.5f, -0.5f, 2}, {-0.5f, -0.5f, 2});
    b.material("floor", 0.0f, 0.0f).quad({-5, -5, 0}, {5, -5, 0}, {5, 5, 0}, {-5, 5, 0});
    if (has_screen) b.quad({0, -9, 1}, {9, -9, 1}, {9, 9, 1}, {0, 9, 1});
    return b.scene();
  }
};

TEST_F(UnderASquareLamp, has_the_closed_form_without_noise) {
  const ProbeRig rig(scene(), no_max_edge, 0.0f);
  for (const auto& at :
       {Vec3(0, 0, 0), Vec3(0.5f, 0.5f, 0), Vec3(2, -1, 0), Vec3(0.3f, 0.1f, 1.5f), Vec3(-4, 3, 0.2f)}) {
    const auto light = rig.at(at, up);
    const auto f = factor(-0.5 - at.x, 0.5 - at.x, -0.5 - at.y, 0.5 - at.y, 2.0 - at.z);
    EXPECT_NEAR(light.illuminance, lux(100.0 * f), 1e-4 * lux(100.0 * f)) << at.x;
    EXPECT_LT(light.sampling_error, 1e-6 * light.illuminance);
  }
  // Behind the lamp, and facing away from it.
  EXPECT_EQ(rig.at({0, 0, 2.5f}, down).illuminance, 0.0);
  EXPECT_EQ(rig.at({0, 0, 1}, down).illuminance, 0.0);
}

// Seen from the origin the screen hides the half x > 0.
TEST_F(UnderASquareLamp, has_the_closed_form_of_the_part_that_a_screen_leaves) {
  const ProbeRig rig(scene(true), no_max_edge, 0.0f);
  const auto half = rig.at({0, 0.2f, 0}, up, {.error = 0.005});
  expect_near(half, lux(100.0 * factor(-0.5, 0.0, -0.7, 0.3, 2.0)));
  EXPECT_GT(half.sampling_error, 0.0);
  EXPECT_LE(half.sampling_error, 0.005 * half.illuminance);
  // From x = 0.25 at height 0 the screen's edge appears at x = -0.25 in the lamp's plane.
  const auto quarter = rig.at({0.25f, 0, 0}, up, {.error = 0.005});
  expect_near(quarter, lux(100.0 * factor(-0.75, -0.5, -0.5, 0.5, 2.0)));
  EXPECT_EQ(rig.at({1.5f, 0, 0}, up).illuminance, 0.0);
}

TEST(ProbeTruth, finds_a_lamp_of_a_millimetre) {
  SceneBuilder b;
  b.material("lamp", 0.0f, 1e6f).quad({0, 1e-3f, 5}, {1e-3f, 1e-3f, 5}, {1e-3f, 0, 5}, {0, 0, 5});
  b.material("floor", 0.0f, 0.0f).quad({-5, -5, 0}, {5, -5, 0}, {5, 5, 0}, {-5, 5, 0});
  const ProbeRig rig(b.scene(), no_max_edge, 0.0f);
  const auto d2 = 25.0 + 4.0;
  const auto E = 1e6 / pi_d * 1e-6 * 25.0 / (d2 * d2);
  EXPECT_NEAR(rig.at({2, 0, 0}, up).illuminance, lux(E), 1e-3 * lux(E));
}

// More lamps than are chosen individually: a ceiling of 20 x 20 tiles, against the rectangle that they fill.
TEST(ProbeTruth, many_lamps) {
  SceneBuilder b;
  for (int i = 0; i < 20; ++i)
    for (int j = 0; j < 20; ++j) {
      const auto x = 0.5f * static_cast<float>(i) - 5.0f, y = 0.5f * static_cast<float>(j) - 5.0f;
      b.material(fmt::format("lamp {} {}", i, j), 0.0f, 50.0f + static_cast<float>((i + j) % 2));
      b.quad({x, y + 0.5f, 2}, {x + 0.5f, y + 0.5f, 2}, {x + 0.5f, y, 2}, {x, y, 2});
    }
  const ProbeRig rig(b.scene(), no_max_edge, 0.0f);
  double sum = 0.0;
  for (int i = 0; i < 20; ++i)
    for (int j = 0; j < 20; ++j) {
      const auto x = 0.5 * i - 5.0, y = 0.5 * j - 5.0;
      sum += (50.0 + (i + j) % 2) * factor(x - 1.0, x - 0.5, y, y + 0.5, 2.0);
    }
  expect_near(rig.at({1, 0, 0}, up, {.error = 0.002}), lux(sum));
}

TEST(ProbeTruth, punctual_lights_are_exact) {
  SceneBuilder b;
  b.material("floor", 0.0f, 0.0f).quad({-5, -5, 0}, {5, -5, 0}, {5, 5, 0}, {-5, 5, 0});
  b.quad({1, -5, 1}, {5, -5, 1}, {5, 5, 1}, {1, 5, 1});  // a shelf
  auto scene = b.scene();
  PointLight point, sun;
  point.position = {0, 0, 3};
  point.intensity = Vec3(40.0f);
  sun.kind = PointLightKind::directional;
  sun.direction = glm::normalize(Vec3(1, 0, -2));
  sun.intensity = Vec3(500.0f);
  scene.point_lights = {point};
  const ProbeRig lamp(scene, no_max_edge, 0.0f);
  for (const auto& at : {Vec3(0, 0, 0.1f), Vec3(-1, 2, 0.1f), Vec3(0.2f, 0.1f, 2)}) {
    const auto to = Vec3d(point.position) - Vec3d(at);
    const auto d = glm::length(to);
    EXPECT_NEAR(lamp.at(at, up).illuminance, lux(40.0 * to.z / (d * d * d)), 1e-4 * lux(40.0 / (d * d)));
    EXPECT_NEAR(lamp.at(at, east).illuminance, lux(40.0 * std::max(0.0, to.x) / (d * d * d)),
                1e-4 * lux(40.0 / (d * d)));
  }
  EXPECT_EQ(lamp.at({3, 0, 0}, up).illuminance, 0.0) << "below the shelf";
  scene.point_lights = {sun};
  const ProbeRig outside(scene, no_max_edge, 0.0f);
  const auto cosine = 2.0 / std::sqrt(5.0);
  EXPECT_NEAR(outside.at({-1, 0, 0}, up).illuminance, lux(500.0 * cosine), 0.5);
  EXPECT_NEAR(outside.at({-1, 0, 4}, {-1, 0, 2}).illuminance, lux(500.0), 0.5);
  EXPECT_EQ(outside.at({3, 0, 0}, up).illuminance, 0.0);
  EXPECT_EQ(outside.at({3, 0, 0}, up).place, ProbePlace::dark);
  EXPECT_LT(outside.at({-1, 0, 0}, up).sampling_error, 1e-6);
}

// The window is a rectangle of the sky; with portals shadow rays find it, without them cosine rays do.
TEST(ProbeTruth, a_window_lights_points_with_and_without_portals_alike) {
  const auto scene = truth::under_sky(truth::window_room(), 10.0f);
  auto patches = make_patches(scene, {.max_edge = 0.5f});
  const ProbeRig plain(patches, 0.0f);
  patches.portals = truth::window_portals();
  const ProbeRig aimed(patches, 0.0f);
  for (const auto& at : {Vec3(1, 0.5f, 0.2f), Vec3(1.8f, 1.9f, 0.1f)}) {
    const ProbeOptions options{.error = 0.005, .max_rays = 1u << 21};
    const auto by_cosine = plain.at(at, {0, -1, 0}, options), by_portal = aimed.at(at, {0, -1, 0}, options);
    // The hole is 0.75 <= x <= 1.25, 0.5 <= z <= 1, in a plane parallel to the element.
    const auto f = factor(0.75 - at.x, 1.25 - at.x, 0.5 - at.z, 1.0 - at.z, at.y);
    expect_near(by_cosine, lux(10.0 * pi_d * f));
    expect_near(by_portal, lux(10.0 * pi_d * f));
    EXPECT_LT(by_portal.rays, by_cosine.rays);
    EXPECT_LT(by_portal.sampling_error, 1e-3 * by_portal.illuminance) << "nothing hides the window";
  }
}

TEST(ProbePlaces, a_point_on_a_surface_is_measured_on_the_side_of_its_normal) {
  SceneBuilder b;  // a table top lit from above
  b.material("top", 0.0f, 0.0f).quad({0, 0, 1}, {2, 0, 1}, {2, 2, 1}, {0, 2, 1});
  auto scene = b.scene();
  PointLight sun;
  sun.kind = PointLightKind::directional;
  sun.direction = down;
  sun.intensity = Vec3(100.0f);
  scene.point_lights = {sun};
  const ProbeRig rig(scene, no_max_edge, 0.0f);
  for (const auto z : {1.0f, 1.00005f, 0.99995f}) {
    const auto top = rig.at({1, 1, z}, up), bottom = rig.at({1, 1, z}, down);
    EXPECT_NEAR(top.illuminance, lux(100.0), 0.01) << z;
    EXPECT_EQ(top.place, ProbePlace::surface);
    EXPECT_EQ(bottom.illuminance, 0.0) << z;
  }
  EXPECT_EQ(rig.at({1, 1, 0.9f}, up).place, ProbePlace::dark);
}

// The ends of a line from wall to wall lie exactly in the walls.
TEST(ProbePlaces, a_point_in_the_plane_of_a_wall_is_measured_in_front_of_it) {
  SceneBuilder b;
  test::add_room(b, {0, 0, 0}, {4, 3, 2}, 0.6f);
  auto scene = b.scene();
  scene.sky = Vec3(1000.0f);  // would be seen through the wall
  const ProbeRig rig(scene, 1.0f, 10.0f);
  for (const auto& at :
       {Vec3(0, 1, 1), Vec3(4, 1, 1), Vec3(2, 3, 1), Vec3(0, 0, 1), Vec3(4, 3, 1), Vec3(0, 1, 0)})
    EXPECT_NEAR(rig.at(at, up).illuminance, lux(6.0), 1e-3) << at.x << " " << at.y << " " << at.z;
}

TEST(ProbePlaces, a_point_inside_of_a_one_sided_body_is_reported) {
  SceneBuilder b;
  b.material("body", 0.5f, 0.0f, false);
  test::add_box(b, {0, 0, 0}, {1, 1, 1});
  auto scene = b.scene();
  scene.sky = Vec3(1.0f);
  const ProbeRig rig(scene, no_max_edge, 1.0f);
  EXPECT_EQ(rig.at({0.5f, 0.5f, 0.5f}, up).place, ProbePlace::behind);
  EXPECT_EQ(rig.at({0.5f, 0.5f, 0.5f}, up).illuminance, 0.0);
  EXPECT_EQ(rig.at({0.5f, 0.5f, 1.5f}, up).place, ProbePlace::free);
}

TEST(ProbeLimits, reports_points_that_miss_the_error) {
  SceneBuilder b;
  b.material("plate", 0.0f, 0.0f).quad({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0});
  const ProbeRig rig(truth::under_sky(b), no_max_edge, 0.0f);
  const auto light = rig.at({0.5f, 0, 0.2f}, {1, 0, -2}, {.error = 1e-5, .max_rays = 4096});
  EXPECT_FALSE(light.reached);
  EXPECT_GT(light.sampling_error, 1e-5 * light.illuminance);
  EXPECT_LE(light.rays, 2u * 4096u);
}

TEST(ProbeLimits, refuses_senseless_options_and_points) {
  const ProbeRig rig(truth::cube_a(), no_max_edge, 1.0f);
  const std::vector<ProbePoint> good = {{{0.5f, 0.5f, 0.5f}, up}};
  const std::vector<ProbePoint> long_normal = {{{0.5f, 0.5f, 0.5f}, {0, 0, 2}}};
  EXPECT_THROW(probe_light(rig.probe, good, {.error = 0.0}, rig.context), InputError);
  EXPECT_THROW(probe_light(rig.probe, good, {.max_rays = 16}, rig.context), InputError);
  EXPECT_THROW(probe_light(rig.probe, good, {.floor = -1.0}, rig.context), InputError);
  EXPECT_THROW(probe_light(rig.probe, long_normal, {}, rig.context), InputError);
  Solution other = rig.light;
  other.irradiance.front.pop_back();
  EXPECT_THROW(SolutionProbe(rig.patches, other, rig.tracer), MismatchError);
}

TEST(ProbeLimits, stops_when_the_monitor_says_so) {
  const ProbeRig rig(truth::cube_a(), no_max_edge, 1.0f);
  const std::vector<ProbePoint> points = {{{0.5f, 0.5f, 0.5f}, up}};
  const auto stopped = rig.context.with_monitor([](const Progress&) { return Next::stop; });
  EXPECT_TRUE(probe_light(rig.probe, points, {}, stopped).empty());
}

}  // namespace
}  // namespace luxel
