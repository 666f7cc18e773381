// SPDX-License-Identifier: Apache-2.0
// Spherical harmonics of the light at a point against closed forms. Risk: as probe_test.cpp.
#include "luxel/render/probe_sphere.h"

#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include <gtest/gtest.h>

#include "luxel/core/error.h"
#include "luxel/core/warp.h"
#include "luxel/render/harmonics.h"

#include "support/axes.h"
#include "support/probe_rig.h"
#include "support/window_rooms.h"

namespace luxel {
namespace {

using test::lux;
using test::ProbeRig;
using test::up;
using truth::SceneBuilder;

constexpr double pi_d = std::numbers::pi;

SphereLight sphere_at(const ProbeRig& rig, const Vec3& position, std::size_t count = 9,
                      double error = 0.003) {
  const std::vector<ProbePoint> points = {{position, up}};
  return probe_spheres(rig.probe, points, count, {.error = error, .max_rays = 1u << 20}, rig.context).front();
}

// The first band of grey light.
std::span<const double> band(const SphereLight& light, std::size_t count = 9) {
  return std::span(light.coefficients).first(count);
}

// Sum over an even grid of directions times the solid angle of each.
template <typename Function>
double integral(const Function& function) {
  constexpr int n = 400;
  double sum = 0.0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const auto z = (2.0 * i + 1.0) / n - 1.0, angle = 2.0 * pi_d * (j + 0.5) / n,
                 r = std::sqrt(1.0 - z * z);
      sum += function(Vec3d(r * std::cos(angle), r * std::sin(angle), z)) * 4.0 * pi_d / (n * n);
    }
  return sum;
}

TEST(Harmonics, are_orthonormal) {
  for (std::size_t i = 0; i < max_harmonics; ++i)
    for (std::size_t k = 0; k <= i; ++k)
      EXPECT_NEAR(integral([&](const Vec3d& d) { return harmonics(d)[i] * harmonics(d)[k]; }),
                  i == k ? 1.0 : 0.0, 1e-4);
}

// The convolution is exact for light that is itself made of these harmonics.
TEST(Harmonics, give_the_irradiance_of_light_that_they_hold) {
  const std::array<double, 9> c = {3.0, 0.2, 0.5, -0.3, 0.1, 0.4, -0.2, 0.3, 0.25};
  const auto n = glm::normalize(Vec3d(1, -2, 3));
  const auto radiance = [&](const Vec3d& d) {
    const auto y = harmonics(d);
    return std::inner_product(c.begin(), c.end(), y.begin(), 0.0);
  };
  EXPECT_NEAR(irradiance_of_harmonics(c, n),
              integral([&](const Vec3d& d) { return radiance(d) * std::max(0.0, glm::dot(n, d)); }), 1e-3);
}

TEST(ProbeSphere, an_even_sky_is_the_first_coefficient) {
  SceneBuilder b;
  b.material("far", 0.0f, 0.0f).quad({0, 0, -1e5f}, {1, 0, -1e5f}, {1, 1, -1e5f}, {0, 1, -1e5f});
  const ProbeRig rig(truth::under_sky(b, 2.0f), no_max_edge, 0.0f);
  const auto light = sphere_at(rig, {0, 0, 0});
  const auto c = band(light);
  EXPECT_NEAR(c[0], 2.0 * std::sqrt(4.0 * pi_d), 1e-5);
  for (std::size_t k = 1; k < 9; ++k) EXPECT_NEAR(c[k], 0.0, 6.0 * light.error * c[0]) << k;
  EXPECT_TRUE(light.reached);
  const auto four = sphere_at(rig, {0, 0, 0}, 4);
  EXPECT_EQ(four.coefficients.size(), 12u);
  EXPECT_NEAR(four.coefficients[4], 2.0 * std::sqrt(4.0 * pi_d), 1e-5) << "green";
}

TEST(ProbeSphere, a_sun_is_its_own_harmonics) {
  SceneBuilder b;
  b.material("far", 0.0f, 0.0f).quad({0, 0, -1e5f}, {1, 0, -1e5f}, {1, 1, -1e5f}, {0, 1, -1e5f});
  auto scene = b.scene();
  PointLight sun;
  sun.kind = PointLightKind::directional;
  const auto to_sun = glm::normalize(Vec3(1, -2, 4));
  sun.direction = -to_sun;
  sun.intensity = Vec3(300.0f);
  scene.point_lights = {sun};
  const ProbeRig rig(scene, no_max_edge, 0.0f);
  const auto light = sphere_at(rig, {0, 0, 0});
  const auto y = harmonics(Vec3d(to_sun));
  for (std::size_t k = 0; k < 9; ++k) EXPECT_NEAR(band(light)[k], 300.0 * y[k], 1e-3) << k;
  EXPECT_EQ(light.error, 0.0);
}

// The upper half is even sky, the lower one a black plate that reaches to the horizon.
TEST(ProbeSphere, a_half_dome_has_its_closed_form_and_gives_the_irradiance_of_the_sky) {
  SceneBuilder b;
  b.material("plate", 0.0f, 0.0f)
      .quad({-3000, -3000, 0}, {3000, -3000, 0}, {3000, 3000, 0}, {-3000, 3000, 0});
  const ProbeRig rig(truth::under_sky(b, 2.0f), no_max_edge, 0.0f);
  const auto light = sphere_at(rig, {0, 0, 0.1f}, 9, 0.002);
  const auto c = band(light);
  const auto allowed = 6.0 * light.error * c[0] + 1e-3;
  EXPECT_NEAR(c[0], 2.0 * 2.0 * pi_d * std::sqrt(1.0 / (4.0 * pi_d)), allowed);
  EXPECT_NEAR(c[2], 2.0 * pi_d * std::sqrt(3.0 / (4.0 * pi_d)), allowed);
  for (const auto k : {1, 3, 4, 5, 6, 7, 8}) EXPECT_NEAR(c[static_cast<std::size_t>(k)], 0.0, allowed) << k;
  EXPECT_NEAR(irradiance_of_harmonics(c, {0, 0, 1}), 2.0 * pi_d, 4.0 * allowed);
  EXPECT_NEAR(irradiance_of_harmonics(c, {1, 0, 0}), pi_d, 4.0 * allowed);
}

// A lamp seen under a small solid angle, in every direction: its coefficients are radiance times solid angle
// times Y.
TEST(ProbeSphere, a_small_lamp_anywhere) {
  for (const auto& direction :
       {Vec3(0, 0, 1), Vec3(1, 1, 1), Vec3(1, 1, 0.01f), Vec3(-3, 0.2f, -1), Vec3(0, -1, 0)}) {
    const auto d = glm::normalize(direction);
    const Frame frame(-d);  // the lamp faces the origin
    constexpr float size = 0.05f;
    const auto centre = 4.0f * d;
    SceneBuilder b;
    b.material("lamp", 0.0f, 1000.0f)
        .quad(centre - size * frame.s - size * frame.t, centre + size * frame.s - size * frame.t,
              centre + size * frame.s + size * frame.t, centre - size * frame.s + size * frame.t);
    const ProbeRig rig(b.scene(), no_max_edge, 0.0f);
    const auto light = sphere_at(rig, {0, 0, 0});
    const auto L_times_angle = 1000.0 / pi_d * 4.0 * double{size} * double{size} / 16.0;
    const auto y = harmonics(Vec3d(d));
    for (std::size_t k = 0; k < 9; ++k)
      EXPECT_NEAR(band(light)[k], L_times_angle * y[k],
                  6.0 * light.error * L_times_angle * y[0] + 2e-3 * L_times_angle)
          << k << " towards " << d.x << " " << d.y << " " << d.z;
  }
}

// Nine harmonics hold the irradiance of any light within a few per cent (Ramamoorthi and Hanrahan 2001).
TEST(ProbeSphere, gives_the_irradiance_of_the_probe_in_a_room) {
  SceneBuilder b;
  test::add_room(b, {0, 0, 0}, {4, 3, 2}, 0.6f);
  b.material("lamp", 0.0f, 500.0f).quad({1, 2, 1.99f}, {3, 2, 1.99f}, {3, 1, 1.99f}, {1, 1, 1.99f});
  const ProbeRig rig(b.scene(), 1.0f, 60.0f);
  const Vec3 at(1.5f, 1, 0.7f);
  const auto light = sphere_at(rig, at);
  for (const auto& n : {Vec3(0, 0, 1), Vec3(0, 0, -1), Vec3(1, 0, 0), Vec3(0, -1, 1)}) {
    const auto unit = glm::normalize(n);
    const auto probe = rig.at(at, n, {.error = 0.003});
    EXPECT_NEAR(lux(irradiance_of_harmonics(band(light), Vec3d(unit))), probe.illuminance,
                0.03 * rig.at(at, up).illuminance)
        << n.x << n.y << n.z;
  }
}

TEST(ProbeSphere, refuses_another_number_of_harmonics) {
  const ProbeRig rig(truth::cube_a(), no_max_edge, 1.0f);
  const std::vector<ProbePoint> points = {{{0.5f, 0.5f, 0.5f}, up}};
  EXPECT_THROW(probe_spheres(rig.probe, points, 5, {}, rig.context), InputError);
}

}  // namespace
}  // namespace luxel
