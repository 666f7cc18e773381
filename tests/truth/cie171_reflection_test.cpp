// SPDX-License-Identifier: Apache-2.0
// CIE 171:2006, reflected light: test cases 5.6, diffuse reflection; 5.7, the same behind an
// obstruction; 5.8, the internal reflected component. The document is not public; geometry is that of
// published validation reports, or stated below. Every true value was derived twice, to at least six digits:
// tools/validation/truth.py. Figures are held to three standard errors, see support/three_errors.h.
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "luxel/patch/make_patches.h"
#include "luxel/solve/sampled.h"

#include "support/axes.h"
#include "support/luminaires.h"
#include "support/probe_rig.h"
#include "support/three_errors.h"
#include "support/truth_scenes.h"

namespace luxel {
namespace {

using test::down;
using test::expect_truth;
using test::north;
using test::up;
using test::WithError;
using truth::SceneBuilder;

// Percent of the exitance of the lit surface S2.
struct Point {
  const char* label;
  Vec3 position, normal;
  double percent;
};

// A sun whose light goes in a direction and gives `lx` on a surface with the normal.
PointLight sun(const Vec3& direction, const Vec3& normal, double lx) {
  PointLight light;
  light.kind = PointLightKind::directional;
  light.direction = glm::normalize(direction);
  const auto cosine = -glm::dot(light.direction, normal);
  light.intensity = Vec3(static_cast<float>(lx / luminous_efficacy) / cosine);
  return light;
}

// Solves the light, and measures E / (rho E of S2) at points; no point sees the sun.
class Reflections {
 public:
  Reflections(const Scene& scene, double exitance) : exitance_(exitance) {
    const Context context(2);
    auto patches = make_patches(scene, {.max_edge = no_max_edge});
    const Tracer tracer(patches, context);
    Solution light;
    solve_sampled(patches, tracer, light, {.error = 1e-3, .error_measure = ErrorMeasure::power}, context);
    rig_ = std::make_unique<test::ProbeRig>(std::move(patches), std::move(light));
  }
  void hold(const Point& point, double error, std::uint32_t max_rays = 1u << 21) const {
    const auto measure = [&](std::uint64_t seed) {
      const auto light =
          rig_->at(point.position, point.normal, {.error = error, .max_rays = max_rays, .seed = seed});
      return WithError{100.0 * light.illuminance / exitance_, 100.0 * light.standard_error() / exitance_};
    };
    expect_truth(measure, point.percent, 1e-5 * point.percent, point.label);
  }

 private:
  double exitance_;  // lm/m², of S2
  std::unique_ptr<test::ProbeRig> rig_;
};

// S2, of reflectance 0.3, lies on the ground around (2, 2) under a sun at 35 degrees in the east, which gives
// 100,000 lx and neither meets the front of the black wall S1-v nor the underside of the black ceiling S1-h.
Scene ground(float side, bool has_receivers) {
  SceneBuilder b;
  const auto l = 2.0f - 0.5f * side, h = 2.0f + 0.5f * side;
  b.material("S2", 0.3f, 0.0f).quad({l, l, 0}, {h, l, 0}, {h, h, 0}, {l, h, 0});
  if (has_receivers) {
    b.material("S1", 0.0f, 0.0f).quad({0, 0, 0.5f}, {0, 0, 3}, {4, 0, 3}, {4, 0, 0.5f});
    b.quad({0, 4, 3}, {4, 4, 3}, {4, 0, 3}, {0, 0, 3});
  }
  auto scene = b.scene();
  const auto altitude = 35.0f * pi / 180.0f;
  scene.point_lights = {sun({-std::cos(altitude), 0, -std::sin(altitude)}, up, 1e5)};
  return scene;
}

// Wall points B to F, 2 m beside the middle of S2, then ceiling points G to J. Configuration factors:
// Lambert's closed form, and Gauss rules.
void hold_ground(const Reflections& light, const std::array<double, 9>& percent, double error,
                 std::uint32_t max_rays = 1u << 21) {
  constexpr std::array<const char*, 9> labels = {"B", "C", "D", "E", "F", "G", "H", "I", "J"};
  for (std::size_t i = 0; i < 9; ++i) {
    const auto step = 0.5f * static_cast<float>(i < 5 ? i : i - 5);
    light.hold(i < 5 ? Point{labels[i], {2, 0, 0.75f + step}, north, percent[i]}
                     : Point{labels[i], {2, 0.25f + step, 3}, down, percent[i]},
               error, max_rays);
  }
}

// The side of S2 of the published reports.
TEST(Cie171Case5_6, a_ground_of_4_m_lights_wall_and_ceiling) {
  hold_ground(
      {ground(4.0f, true), 0.3 * 1e5},
      {35.900505, 27.991624, 21.638511, 16.716315, 12.967372, 26.795188, 30.938711, 33.975719, 35.566592},
      1e-3);
}

// Sides chosen here, a small one and a practically unbounded one.
TEST(Cie171Case5_6, a_ground_of_half_a_metre_lights_wall_and_ceiling) {
  hold_ground({ground(0.5f, true), 0.3 * 1e5},
              {0.57993570, 0.64436555, 0.55635390, 0.43329628, 0.32510908, 0.49139644, 0.63913036, 0.77764452,
               0.86426003},
              5e-3);
}

// Points stand free, since the ceiling would throw a shadow, and a wall sees half of the ground. From the
// ceiling one ray in 8,500 passes over the edge of the ground: the 1,024 rays with which a probe begins are
// likely to miss it, agree with each other and end the measurement at 100 %, 0.012 % too much and far below
// the error that is usually requested. An error that is never reached takes all 262,144 rays.
TEST(Cie171Case5_6, a_ground_of_500_m_lights_wall_and_ceiling) {
  hold_ground(
      {ground(500.0f, false), 0.3 * 1e5},
      {49.830481, 49.717470, 49.604463, 49.491461, 49.378466, 99.988217, 99.988217, 99.988218, 99.988218},
      1e-15, 1u << 18);
}

// S2, of reflectance 0.6, is the wall y = 4 of 4 x 3 m under a sun at the horizon that passes along all other
// fronts. A black obstruction of 4 x 0.2 x 1 m stands on the floor from y = 2.5 to 2.7.
TEST(Cie171Case5_7, an_obstruction_hides_a_part_of_the_reflecting_wall) {
  SceneBuilder b;
  b.material("S2", 0.6f, 0.0f).quad({4, 4, 0}, {4, 4, 3}, {0, 4, 3}, {0, 4, 0});
  b.material("S1", 0.0f, 0.0f)
      .quad({0, 0, 0}, {0, 0, 3}, {4, 0, 3}, {4, 0, 0})
      .quad({0, 0, 0}, {4, 0, 0}, {4, 2.5f, 0}, {0, 2.5f, 0});
  test::add_box(b.material("obstruction", 0.0f, 0.0f), {0, 2.5f, 0}, {4, 2.7f, 1});
  auto scene = b.scene();
  scene.point_lights = {sun({-0.97f, 0.26f, 0}, {0, -1, 0}, 1e5)};
  const Reflections light(scene, 0.6 * 1e5);
  // The part of S2 that each point sees, as for 5.6. J sees the upper edge of S2 at most.
  const std::array<Point, 11> points = {{{"A", {2, 0, 2.75f}, north, 16.070642},
                                         {"B", {2, 0, 2.25f}, north, 16.329677},
                                         {"C", {2, 0, 1.75f}, north, 15.398810},
                                         {"D", {2, 0, 1.25f}, north, 13.322018},
                                         {"E", {2, 0, 0.75f}, north, 10.316924},
                                         {"F", {2, 0, 0.25f}, north, 7.0789690},
                                         {"G", {2, 0.25f, 0}, up, 3.3823352},
                                         {"H", {2, 0.75f, 0}, up, 3.6289856},
                                         {"I", {2, 1.25f, 0}, up, 3.0129512},
                                         {"J", {2, 1.75f, 0}, up, 0.0},
                                         {"K", {2, 2.25f, 0}, up, 0.0}}};
  for (const auto& point : points) light.hold(point, 2e-3);
}

// 10,000 lm in the middle of a cube of 4 m and one reflectance: the mean indirect illuminance of its faces is
// rho Phi / (S (1 - rho)), by the power balance and by bounces between the faces.
TEST(Cie171Case5_8, the_internal_reflected_component_of_a_cube) {
  constexpr double flux = 10000.0, cd = flux / (4.0 * std::numbers::pi);
  for (const auto& [rho, lx] : {std::pair(0.05f, 5.4824561),
                                {0.1f, 11.574074},
                                {0.2f, 26.041667},
                                {0.3f, 44.642857},
                                {0.5f, 104.166667},
                                {0.7f, 243.055556},
                                {0.9f, 937.5},
                                {0.95f, 1979.166667}}) {
    SceneBuilder b;
    test::add_room(b, {0, 0, 0}, {4, 4, 4}, rho);
    auto scene = b.scene();
    scene.point_lights = {test::luminaire({GoniometerType::c, {0.0, 180.0}, {0.0}, {cd, cd}}, {}, {2, 2, 2})};
    const auto patches = make_patches(scene, {.max_edge = 1.0f});
    const Context context(2);
    const Tracer tracer(patches, context);
    const auto measure = [&](std::uint64_t seed) {
      Solution light;
      const auto report =
          solve_sampled(patches, tracer, light,
                        {.error = 2e-3, .error_measure = ErrorMeasure::power, .seed = seed}, context);
      const auto& all = report.means.received;
      const auto to_lux = luminous_efficacy / 96.0;
      return WithError{to_lux * (all.power[0] - report.energy.emitted[0]), to_lux * all.standard_error[0]};
    };
    expect_truth(measure, lx, 1e-5 * (lx + flux / 96.0), fmt::format("reflectance {}", rho));
  }
}

}  // namespace
}  // namespace luxel
