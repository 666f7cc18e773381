// SPDX-License-Identifier: Apache-2.0
// UGR of observers against closed forms, hand-made rooms, and the table of CIE 190.
#include "luxel/lighting/glare.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "luxel/core/error.h"
#include "luxel/lighting/position_index.h"
#include "luxel/lighting/ugr_table.h"
#include "luxel/patch/make_patches.h"
#include "luxel/scene/luminous_efficacy.h"
#include "luxel/solve/sampled.h"

#include "support/luminaires.h"
#include "support/probe_rig.h"
#include "support/truth_scenes.h"

namespace luxel {
namespace {

using test::cosine_distribution;
using test::luminaire;
using test::ProbeRig;

const Vec3d up(0.0, 0.0, 1.0);

// A room with its corner at the origin, all surfaces facing inwards.
truth::SceneBuilder room(const Vec3& s, const RoomReflectance& rho) {
  const auto wall = static_cast<float>(rho.wall);
  truth::SceneBuilder b;
  b.material("floor", static_cast<float>(rho.floor), 0.0f)
      .quad({0, 0, 0}, {s.x, 0, 0}, {s.x, s.y, 0}, {0, s.y, 0})
      .material("ceiling", static_cast<float>(rho.ceiling), 0.0f)
      .quad({0, 0, s.z}, {0, s.y, s.z}, {s.x, s.y, s.z}, {s.x, 0, s.z})
      .material("wall", wall, 0.0f)
      .quad({0, 0, 0}, {0, s.y, 0}, {0, s.y, s.z}, {0, 0, s.z})
      .quad({s.x, 0, 0}, {s.x, 0, s.z}, {s.x, s.y, s.z}, {s.x, s.y, 0})
      .quad({0, 0, 0}, {0, 0, s.z}, {s.x, 0, s.z}, {s.x, 0, 0})
      .quad({0, s.y, 0}, {s.x, s.y, 0}, {s.x, s.y, s.z}, {0, s.y, s.z});
  return b;
}

constexpr float even = 10.0f;  // W/m² on every front of the hand-made rooms

// The background of a room where every surface reflects the same: rho E / pi.
double even_background(double rho) { return rho * test::lux(even) / std::numbers::pi; }

ObservedGlare observe(const ProbeRig& rig, const GlareObserver& observer) {
  const GlareMeter meter(rig.probe, up);
  return observe_glare(meter, std::vector{observer}, {}, rig.context).at(0);
}

// A panel of 0.6 x 0.3 m 1.5 m above the eye and 3 m in front, 0.9 m aside.
TEST(Glare, of_one_luminaire_has_the_closed_form) {
  auto scene = room({8, 8, 4}, {0.5, 0.5, 0.5}).scene();
  scene.point_lights = {
      luminaire(cosine_distribution(1000.0), {OpeningShape::rectangle, {0.6, 0.3, 0}}, {5.0f, 4.9f, 2.7f})};
  const ProbeRig rig(scene, no_max_edge, even);
  const auto seen = observe(rig, {{2.0f, 4.0f, 1.2f}, {1, 0, 0}});
  EXPECT_NEAR(seen.background, even_background(0.5), 1e-4 * seen.background);
  ASSERT_EQ(seen.sources.size(), 1u);
  const auto& source = seen.sources[0];
  const auto squared_distance = 9.0 + 0.81 + 2.25, distance = std::sqrt(squared_distance);
  EXPECT_EQ(source.name, "luminaire");
  EXPECT_NEAR(source.luminance, 1000.0 / 0.18, 1e-3 * source.luminance);
  EXPECT_NEAR(source.solid_angle, 0.18 * 1.5 / distance / squared_distance, 1e-5 * source.solid_angle);
  EXPECT_NEAR(source.position_index, *guth_index(0.3, 0.5), 1e-5);
  EXPECT_EQ(source.visible, 1.0);
  const auto p = source.position_index;
  const auto glare = std::pow(1000.0 / 0.18, 2) * 0.18 * 1.5 / (distance * squared_distance) / (p * p);
  EXPECT_NEAR(seen.ugr, 8.0 * std::log10(0.25 * glare / even_background(0.5)), 2e-3);
  EXPECT_LE(seen.low, seen.ugr);
  EXPECT_GE(seen.high, seen.ugr);
  // The other way, there is nothing to see.
  const auto away = observe(rig, {{2.0f, 4.0f, 1.2f}, {-1, 0, 0}});
  EXPECT_EQ(away.ugr, ObservedGlare::nothing);
  EXPECT_TRUE(away.sources.empty());
  EXPECT_NEAR(away.background, even_background(0.5), 1e-4 * away.background);
}

// A quad of the same luminance, so small that the solid angle of its middle is that of all: the same source.
// It has four patches, which are one source.
TEST(Glare, of_a_surface_that_emits_is_that_of_a_luminaire) {
  auto b = room({8, 8, 4}, {0.5, 0.5, 0.5});
  const auto watts = static_cast<float>(std::numbers::pi * 5000.0 / luminous_efficacy);
  b.material("panel", 0.0f, watts)
      .quad({4.97f, 4.885f, 2.7f}, {4.97f, 4.915f, 2.7f}, {5.0f, 4.915f, 2.7f}, {5.0f, 4.885f, 2.7f})
      .quad({5.0f, 4.885f, 2.7f}, {5.0f, 4.915f, 2.7f}, {5.03f, 4.915f, 2.7f}, {5.03f, 4.885f, 2.7f});
  const ProbeRig rig(b.scene(), no_max_edge, even);
  const auto seen = observe(rig, {{2.0f, 4.0f, 1.2f}, {1, 0, 0}});
  ASSERT_EQ(seen.sources.size(), 1u);
  const auto& source = seen.sources[0];
  EXPECT_EQ(source.name, "panel");
  EXPECT_NEAR(source.luminance, 5000.0, 0.5);
  const auto solid_angle = 0.06 * 0.03 * 1.5 / std::pow(12.06, 1.5);
  EXPECT_NEAR(source.solid_angle, solid_angle, 1e-3 * solid_angle);
  EXPECT_NEAR(source.position_index, *guth_index(0.3, 0.5), 1e-3);
  EXPECT_EQ(source.visible, 1.0);
  EXPECT_TRUE(observe(rig, {{2.0f, 4.9f, 3.5f}, {1, 0, 0}}).sources.empty()) << "from behind";
}

// A screen hides the left half of the opening; a wider one all of it.
TEST(Glare, sees_what_is_not_hidden) {
  const auto with_screen = [&](float from, float to) {
    auto b = room({8, 8, 4}, {0.5, 0.5, 0.5});
    b.material("screen", 0.5f, 0.0f)
        .quad({4.0f, from, 1.0f}, {4.0f, to, 1.0f}, {4.0f, to, 3.5f}, {4.0f, from, 3.5f});
    auto scene = b.scene();
    scene.point_lights = {luminaire(cosine_distribution(1000.0), {OpeningShape::rectangle, {0.01, 0.8, 0}},
                                    {6.0f, 4.0f, 2.2f})};
    return scene;
  };
  const GlareObserver observer{{2.0f, 4.0f, 1.2f}, {1, 0, 0}};
  const ProbeRig whole_rig(with_screen(6.0f, 7.0f), no_max_edge, even);
  const auto whole = observe(whole_rig, observer);
  const ProbeRig half_rig(with_screen(4.0f, 5.0f), no_max_edge, even);
  const auto half = observe(half_rig, observer);
  ASSERT_EQ(whole.sources.size() + half.sources.size(), 2u);
  EXPECT_NEAR(half.sources[0].visible, 0.5, 1.0 / 64.0);
  EXPECT_NEAR(half.sources[0].solid_angle / whole.sources[0].solid_angle, 0.5, 1.0 / 64.0);
  EXPECT_EQ(half.sources[0].luminance, whole.sources[0].luminance);
  EXPECT_GT(half.high - half.low, whole.high - whole.low) << "visibility is uncertain";
  const ProbeRig hidden_rig(with_screen(3.0f, 5.0f), no_max_edge, even);
  EXPECT_TRUE(observe(hidden_rig, observer).sources.empty());
}

TEST(Glare, ignores_what_ugr_ignores) {
  auto scene = room({40, 8, 4}, {0.5, 0.5, 0.5}).scene();
  const LuminousOpening flat{OpeningShape::rectangle, {0.3, 0.3, 0}};
  scene.point_lights = {
      luminaire(cosine_distribution(1000.0), flat, {2.5f, 4.0f, 3.0f}),   // too high: H/R = 3.6
      luminaire(cosine_distribution(1000.0), flat, {38.0f, 4.0f, 3.0f}),  // seen 2.9 degrees flat
      luminaire(cosine_distribution(1000.0), {}, {6.0f, 4.0f, 3.0f}),     // a point
      luminaire(cosine_distribution(1000.0), {OpeningShape::ellipsoid, {0.3, 0.3, 0.3}}, {2.5f, 6.0f, 1.3f})};
  const ProbeRig rig(scene, no_max_edge, even);
  const auto seen = observe(rig, {{2.0f, 4.0f, 1.2f}, {1, 0, 0}});
  EXPECT_EQ(seen.sources.size(), 0u);
  EXPECT_EQ(seen.ignored, 3u);
  EXPECT_EQ(seen.ugr, ObservedGlare::nothing);
}

// Observers at one place differ by their random numbers alone: the spread of their backgrounds is the stated
// error, which is widened for so few replicates (by 1.18, to the square 1.4), or less.
TEST(Glare, states_the_error_of_its_background) {
  const ProbeRig rig(room({8, 5, 3}, {0.9, 0.4, 0.1}).scene(), no_max_edge, even);
  const GlareMeter meter(rig.probe, up);
  const std::vector<GlareObserver> observers(200, {{2.0f, 2.2f, 1.2f}, glm::normalize(Vec3(1, 0.3f, 0.2f))});
  const auto seen = observe_glare(meter, observers, {.error = 0.02, .max_rays = 1024}, rig.context);
  double mean = 0.0, spread = 0.0, stated = 0.0;
  for (const auto& s : seen) mean += s.background / 200.0;
  for (const auto& s : seen) {
    spread += (s.background - mean) * (s.background - mean) / 199.0;
    stated += s.background_error * s.background_error / 200.0;
    EXPECT_EQ(s.sampling, 1.0);  // the solution of the rig has no errors
  }
  EXPECT_GT(spread, 0.3 * stated);
  EXPECT_LT(spread, 1.1 * stated);
}

TEST(Glare, repeats_and_refuses) {
  auto scene = room({8, 8, 4}, {0.5, 0.5, 0.5}).scene();
  scene.point_lights = {
      luminaire(cosine_distribution(1000.0), {OpeningShape::rectangle, {0.6, 0.3, 0}}, {5.0f, 4.9f, 2.7f})};
  const ProbeRig rig(scene, no_max_edge, even);
  const GlareMeter meter(rig.probe, up);
  const std::vector<GlareObserver> observers(3, {{2.0f, 4.0f, 1.2f}, {1, 0, 0}});
  const auto one = observe_glare(meter, observers, {}, Context(1));
  const auto two = observe_glare(meter, observers, {}, Context(2));
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(one[i].ugr, two[i].ugr);
    EXPECT_EQ(one[i].background, two[i].background);
  }
  EXPECT_THROW(observe_glare(meter, std::vector{GlareObserver{{0, 0, 0}, {2, 0, 0}}}, {}, Context(1)),
               InputError);
  EXPECT_THROW(observe_glare(meter, observers, {.max_rays = 10}, Context(1)), InputError);
}

// A luminaire whose light differs along and across its length, in the 4H x 8H room: laid across the line of
// sight and along it, the sums over what an observer sees are those of the table.
TEST(Glare, has_the_sums_of_the_table_crosswise_and_endwise) {
  std::vector<double> gamma, candela;
  const std::vector<double> planes = {0, 15, 30, 45, 60, 75, 90};
  for (int i = 0; i <= 18; ++i) gamma.push_back(5.0 * i);
  for (int c = 0; c <= 6; ++c)
    for (int i = 0; i <= 18; ++i) candela.push_back((18.0 - i) * (10.0 + 5.0 * c));
  Photometry panel;
  panel.format = "EULUMDAT";
  panel.intensity = {GoniometerType::c, gamma, planes, candela};
  panel.opening = {OpeningShape::box, {0.2, 1.2, 0.05}};
  constexpr double spacing = 1.0, h = 2.0;
  for (const bool endwise : {false, true}) {
    auto scene = room({8, 16, 4}, {0.5, 0.5, 0.5}).scene();
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 8; ++j) {
        auto light = luminaire(panel.intensity, panel.opening,
                               {static_cast<float>((i + 0.5) * h), static_cast<float>((j + 0.5) * h), 3.2f});
        if (!endwise) {  // its length, local Y, along x; the observer looks along y
          light.local_x = {0, -1, 0};
          light.local_y = {1, 0, 0};
        }
        scene.point_lights.push_back(light);
      }
    const ProbeRig rig(scene, no_max_edge, even);
    const auto seen = observe(rig, {{4.0f, 0.001f, 1.2f}, {0, 1, 0}});
    double sum = 0.0;
    for (const auto& source : seen.sources) sum += source.glare();
    const auto table = ugr_terms(panel, spacing, 10, 0, endwise).glare;
    EXPECT_NEAR(sum, table, 3e-3 * table) << (endwise ? "endwise" : "crosswise");
    EXPECT_GT(seen.sources.size(), 20u);
  }
}

// The 4H x 8H room of the table, luminaires 0.5 H apart, as a scene: the eye is at the height of the floor,
// which stands for the plane of the eyes. The sum over sources is that of the table. The table's background
// is the mean over all walls; that of the scene is the mean over observers spread over all walls.
TEST(Glare, in_the_solved_room_is_that_of_the_table) {
  constexpr double h = 2.0, spacing = 0.5;
  const Vec3 size(8, 16, 2);
  Photometry panel;
  panel.format = "EULUMDAT";
  panel.intensity = cosine_distribution(300.0);
  panel.opening = {OpeningShape::rectangle, {0.3, 0.3, 0}};
  auto scene = room(size, ugr_reflectances[0]).scene();
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 16; ++j)
      scene.point_lights.push_back(luminaire(
          panel.intensity, panel.opening,
          {static_cast<float>((i + 0.5) * spacing * h), static_cast<float>((j + 0.5) * spacing * h), 2.0f}));
  check_scene(scene);
  auto patches = make_patches(scene, {.max_edge = 0.5f});
  const Context context(2);
  const Tracer tracer(patches, context);
  Solution light;
  solve_sampled(patches, tracer, light, {.error = 0.005, .error_measure = ErrorMeasure::power}, context);
  const ProbeRig rig(std::move(patches), std::move(light));
  const GlareMeter meter(rig.probe, up);
  const auto seen =
      observe_glare(meter, std::vector<GlareObserver>{{{4.0f, 0.002f, 0.002f}, {0, 1, 0}}}, {}, context)
          .at(0);
  const auto table = ugr_terms(panel, spacing, 10, 0, false);
  double sum = 0.0;
  for (const auto& source : seen.sources) sum += source.glare();
  EXPECT_NEAR(sum, table.glare, 5e-3 * table.glare);

  std::vector<GlareObserver> on_walls;
  for (int i = 0; i < 24; ++i)
    for (int j = 0; j < 3; ++j) {
      const auto z = static_cast<float>((j + 0.5) * 2.0 / 3.0);
      const auto along = static_cast<float>((i % 16) + 0.5);
      on_walls.push_back(i < 16 ? GlareObserver{{0.002f, along, z}, {1, 0, 0}}
                                : GlareObserver{{along, 0.002f, z}, {0, 1, 0}});
    }
  double background = 0.0;
  for (const auto& at_wall : observe_glare(meter, on_walls, {}, context))
    background += at_wall.background / static_cast<double>(on_walls.size());
  // Three surfaces of constant radiosity are not quite the room: measured 2.1 % less.
  EXPECT_NEAR(background, table.background, 0.03 * table.background);
  // The middle of the end wall is darker than the walls are in the mean, by 12 % here: UGR is higher.
  EXPECT_NEAR(seen.ugr - table.ugr(), 8.0 * std::log10(table.background / seen.background), 0.02);
  EXPECT_NEAR(seen.ugr, table.ugr(), 0.6);
}

}  // namespace
}  // namespace luxel
