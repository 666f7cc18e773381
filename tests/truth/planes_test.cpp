// SPDX-License-Identifier: Apache-2.0
// Calculation planes against closed forms: even light, the area source of CIE 171:2006 5.3, cylindrical
// illuminance of points and half-domes. Seeds are fixed; noisy numbers are compared within their intervals,
// or six standard errors, so that with other random numbers a test would fail with a chance below one in a
// thousand.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "luxel/core/error.h"
#include "luxel/lighting/calculation_plane.h"

#include "support/probe_rig.h"
#include "support/window_rooms.h"

namespace luxel {
namespace {

using test::lux;
using test::ProbeRig;
using truth::SceneBuilder;

constexpr double pi_d = std::numbers::pi;
const Vec3d up(0, 0, 1);

std::vector<CalculationArea> areas(const std::string& text) {
  return areas_of(parse_toml(text, "test.toml"), RequirementTable(), up);
}
AreaScene scene_of(const ProbeRig& rig) { return {rig.patches, rig.light, rig.tracer, up, nullptr}; }
PlaneResult measured(const ProbeRig& rig, const CalculationArea& area, const ProbeOptions& options = {}) {
  return measure_plane(rig.probe, area, scene_of(rig), options, rig.context).value();
}
PlaneResult measured(const ProbeRig& rig, const std::string& text, const ProbeOptions& options = {}) {
  return measured(rig, areas(text).front(), options);
}

// Every surface reflects 36 W/m² from all around.
ProbeRig even_room() {
  SceneBuilder b;
  test::add_room(b, {0, 0, 0}, {4, 3, 2.5f}, 0.6f);
  return {b.scene(), 1.0f, 60.0f};
}
const std::string plane = "name = \"plane\"\npolygon = [[0, 0], [4, 0], [4, 3], [0, 3]]\nheight = 0.75\n";

TEST(Planes, even_light_is_even) {
  const auto rig = even_room();
  const auto E = lux(36.0);
  const auto r = measured(
      rig, "maintenance = 0.5\n[[area]]\n" + plane +
               "kind = \"task\"\ncylindrical = true\nsemicylindrical = [1, 0, 0]\nEm = 3000\nU0 = 0.6\n"
               "Ud = 0.99\nmodelling = [0.5, 1.5]\n");
  EXPECT_EQ(r.grid.columns, 8u) << "p = 0.527 m";
  EXPECT_EQ(r.grid.rows, 6u);
  EXPECT_TRUE(r.grid.is_by_rule);
  for (const auto& figure : {r.mean, r.min, r.max}) {
    EXPECT_NEAR(figure.value, 0.5 * E, 1e-4 * E);
    EXPECT_NEAR(figure.high - figure.low, 0.0, 1e-3 * E);
  }
  EXPECT_NEAR(r.min_over_mean.value, 1.0, 1e-4);
  EXPECT_NEAR(r.cylindrical->value, 0.5 * E, 0.02 * E);
  EXPECT_LE(r.cylindrical->low, 0.5 * E);
  EXPECT_GE(r.cylindrical->high, 0.5 * E);
  EXPECT_NEAR(r.semicylindrical->value, 0.5 * E, 0.02 * E);
  EXPECT_NEAR(r.modelling->value, 1.0, 0.04);
  ASSERT_EQ(r.verdicts.size(), 5u);
  for (const auto& verdict : r.verdicts) EXPECT_EQ(verdict.compliance, Compliance::met) << verdict.quantity;
  EXPECT_EQ(measured(rig, "maintenance = 0.4\n[[area]]\n" + plane + "Em = 3000\n").compliance(),
            Compliance::not_met);
  // Without reflections nothing is left.
  EXPECT_EQ(measured(rig, "[[area]]\n" + plane + "direct = true\n").max.value, 0.0);
}

// CIE 171:2006 5.3: a diffuse source of 1 x 1 m and 1000 cd in the middle of the ceiling of a black room of
// 4 x 4 x 3 m. Values of the closed form; lamps that nothing hides have no noise.
TEST(Planes, have_the_area_source_of_CIE_171) {
  SceneBuilder b;
  test::add_room(b, {0, 0, 0}, {4, 4, 3}, 0.0f);
  b.material("source", 0.0f, static_cast<float>(1000.0 * pi_d / 179.0))
      .quad({1.5f, 2.5f, 2.9999f}, {2.5f, 2.5f, 2.9999f}, {2.5f, 1.5f, 2.9999f}, {1.5f, 1.5f, 2.9999f});
  const ProbeRig rig(b.scene(), no_max_edge, 0.0f);
  const auto floor = measured(
      rig,
      "[[area]]\nname = \"floor\"\nkind = \"escape_route\"\nline = [[2, 0, 0], [2, 4, 0]]\nspacing = 0.5\n");
  ASSERT_EQ(floor.light.size(), 8u);
  EXPECT_NEAR(floor.light[0].illuminance, 61.424, 0.02) << "G";
  EXPECT_NEAR(floor.light[2].illuminance, 95.667, 0.02) << "I";
  EXPECT_NEAR(floor.min.value, 61.424, 0.02);
  EXPECT_NEAR(floor.max_over_min.value, floor.light[3].illuminance / 61.424, 2e-3);
  EXPECT_EQ(floor.compliance(), Compliance::met);
  const auto wall = measured(rig,
                             "[[area]]\nname = \"wall\"\nline = [[2, 0, 3], [2, 0, 0]]\nspacing = 0.5\n"
                             "normal = [0, 1, 0]\n");
  ASSERT_EQ(wall.light.size(), 6u);
  EXPECT_NEAR(wall.light[0].illuminance, 32.677, 0.03) << "A";
  EXPECT_NEAR(wall.light[2].illuminance, 81.323, 0.02) << "C";
  EXPECT_NEAR(wall.light[4].illuminance, 53.404, 0.02) << "E";
}

// Points that face a lamp of even intensity: I / d², without a cosine.
TEST(Planes, facing_a_point_lamp_follow_the_inverse_square) {
  SceneBuilder b;
  b.material("far", 0.0f, 0.0f).quad({0, 0, -1e4f}, {1, 0, -1e4f}, {1, 1, -1e4f}, {0, 1, -1e4f});
  auto scene = b.scene();
  PointLight lamp;
  lamp.position = {1.0f, 2.0f, 3.0f};
  lamp.intensity = Vec3(100.0f);
  scene.point_lights.push_back(lamp);
  const ProbeRig rig(scene, no_max_edge, 0.0f);
  const auto r = measured(rig,
                          "[[area]]\nname = \"field\"\npolygon = [[0, 0], [4, 0], [4, 2], [0, 2]]\n"
                          "height = 1\nspacing = 1\nfacing = [1, 2, 3]\n");
  ASSERT_EQ(r.light.size(), 8u);
  for (std::size_t i = 0; i < r.light.size(); ++i) {
    const auto way = Vec3d(1, 2, 3) - r.grid.position[i];
    EXPECT_NEAR(glm::length(r.grid.direction(i) - glm::normalize(way)), 0.0, 1e-12);
    EXPECT_NEAR(r.light[i].illuminance, lux(100.0 / glm::dot(way, way)), 1e-4 * lux(100.0));
  }
  EXPECT_THROW(measured(rig,
                        "[[area]]\nname = \"field\"\npolygon = [[0, 0], [4, 0], [4, 2], [0, 2]]\n"
                        "height = 1\nspacing = 1\nfacing = [0.5, 0.5, 1]\n"),
               InputError);
}

// A sun at 30 degrees from the vertical and 60 degrees of azimuth from x: exact.
TEST(Planes, cylindrical_illuminance_of_a_sun_is_exact) {
  SceneBuilder b;
  b.material("far", 0.0f, 0.0f).quad({0, 0, -1e4f}, {1, 0, -1e4f}, {1, 1, -1e4f}, {0, 1, -1e4f});
  auto scene = b.scene();
  PointLight sun;
  sun.kind = PointLightKind::directional;
  const auto polar = pi_d / 6.0, azimuth = pi_d / 3.0;
  sun.direction =
      -Vec3(std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth), std::cos(polar));
  sun.intensity = Vec3(100.0f);
  scene.point_lights = {sun};
  const ProbeRig rig(scene, no_max_edge, 0.0f);
  const std::vector<ProbePoint> points = {{{0, 0, 1}, {0, 0, 1}}};
  const CylinderOptions cylinder{.axis = {0, 0, 1}, .facing = Vec3(3, 0, 7)};
  const auto light = probe_cylinders(rig.probe, points, cylinder, {}, rig.context).front();
  EXPECT_NEAR(light.cylindrical.illuminance, lux(100.0 * 0.5 / pi_d), 0.01);
  EXPECT_NEAR(light.semicylindrical.illuminance, lux(100.0 * 0.5 * 1.5 / pi_d), 0.01);
  EXPECT_NEAR(light.horizontal.illuminance, lux(100.0 * std::cos(polar)), 0.02);
  EXPECT_EQ(light.cylindrical.standard_error(), 0.0);
  EXPECT_THROW(
      probe_cylinders(rig.probe, points, {.axis = {0, 0, 1}, .facing = Vec3(0, 0, 1)}, {}, rig.context),
      InputError);
}

// Even sky of 2 W/(m² sr) over a black plate: half of the cylinder's light is there, so E_z / E_h = 1/2.
TEST(Planes, half_a_dome_has_the_modelling_index_of_one_half) {
  SceneBuilder b;
  b.material("plate", 0.0f, 0.0f)
      .quad({-3000, -3000, 0}, {3000, -3000, 0}, {3000, 3000, 0}, {-3000, 3000, 0});
  const ProbeRig rig(truth::under_sky(b, 2.0f), no_max_edge, 0.0f);
  const auto r = measured(rig, "[[area]]\n" + plane + "spacing = 2\ncylindrical = true\n", {.error = 0.005});
  EXPECT_NEAR(r.mean.value, lux(2.0 * pi_d), 0.01 * lux(2.0 * pi_d));
  EXPECT_NEAR(r.cylindrical->value, lux(pi_d), 0.01 * lux(pi_d));
  EXPECT_LE(r.modelling->low, 0.5);
  EXPECT_GE(r.modelling->high, 0.5);
  EXPECT_NEAR(r.modelling->value, 0.5, 0.01);
}

// Two rooms side by side; a band of 3.5 m around the desk reaches beyond the walls and into the other room.
TEST(Planes, bands_stay_in_the_room_of_their_task) {
  SceneBuilder b;
  test::add_room(b, {0, 0, 0}, {4, 3, 2.5f}, 0.6f);
  test::add_room(b, {4.1f, 0, 0}, {9, 3, 2.5f}, 0.6f);
  const ProbeRig rig(b.scene(), 1.0f, 60.0f);
  const auto all = areas(
      "[[area]]\nname = \"desk\"\nkind = \"task\"\npolygon = [[2, 1], [3, 1], [3, 2], [2, 2]]\nheight = "
      "0.75\n"
      "Em = 500\nsurround = true\n");
  ASSERT_EQ(all.size(), 3u);
  const auto scene = scene_of(rig);
  const auto surround = make_grid(all[1], scene), background = make_grid(all[2], scene);
  for (const auto& at : surround.position) {
    EXPECT_TRUE(at.x > 1.5 && at.x < 3.5 && at.y > 0.5 && at.y < 2.5);
    EXPECT_FALSE(at.x > 2 && at.x < 3 && at.y > 1 && at.y < 2);
  }
  EXPECT_NEAR(background.width, 4.0, 0.09) << "the room's, not the band's 8 m";
  EXPECT_NEAR(background.height, 3.0, 0.09);
  ASSERT_GT(background.points(), 20u);
  for (const auto& at : background.position) {
    EXPECT_TRUE(at.x > 0 && at.x < 4 && at.y > 0 && at.y < 3) << at.x << " " << at.y;
    EXPECT_FALSE(at.x > 1.5 && at.x < 3.5 && at.y > 0.5 && at.y < 2.5);
  }
}

TEST(Planes, lie_on_surfaces_by_name) {
  const auto rig = even_room();
  const auto area =
      areas("[[area]]\nname = \"a\"\nsurface = \"floor\"\nborder = 0.5\nspacing = 0.5\n").front();
  const auto grid = make_grid(area, scene_of(rig));
  EXPECT_EQ(grid.columns, 6u);
  EXPECT_EQ(grid.rows, 4u);
  EXPECT_EQ(grid.points(), 24u);
  EXPECT_NEAR(glm::length(grid.normal - up), 0.0, 1e-6);
  EXPECT_NEAR(glm::length(grid.position.front() - Vec3d(0.75, 0.75, 0)), 0.0, 1e-5);
  const auto refused = [&](const std::string& text) -> std::string {
    try {
      make_grid(areas("[[area]]\nname = \"a\"\n" + text).front(), scene_of(rig));
    } catch (const InputError& error) {
      return error.what();
    }
    return "nothing";
  };
  EXPECT_NE(refused("surface = \"walls\"").find("is not flat"), std::string::npos);
  EXPECT_NE(refused("surface = \"door\"").find("no material is called 'door'"), std::string::npos);
  EXPECT_NE(refused("surface = \"floor\"\nborder = 2").find("the border of 2 m leaves nothing"),
            std::string::npos);
  EXPECT_NE(refused("surface = \"floor\"\nspacing = 1e-4").find("expected a larger one"), std::string::npos);
  // The plan of the room at desk height is its rectangle.
  const auto desk = make_grid(areas("[[area]]\n" + plane).front(), scene_of(rig));
  const auto plan = plan_of(rig.patches, desk, 0.02);
  ASSERT_EQ(plan.size(), 1u);
  EXPECT_LE(plan[0].size(), 6u) << "corners only, and the start";
  double length = 0.0;
  for (std::size_t i = 1; i < plan[0].size(); ++i) length += glm::length(plan[0][i] - plan[0][i - 1]);
  EXPECT_NEAR(length, 14.0, 1e-3);
}

// A tilted triangle: the grid follows its plane and keeps to its inside.
TEST(Planes, may_be_tilted_polygons) {
  const auto rig = even_room();
  const auto area =
      areas("[[area]]\nname = \"a\"\npolygon = [[1, 1, 0.5], [3, 1, 0.5], [3, 2, 1.5]]\nspacing = 0.1\n")
          .front();
  const auto grid = make_grid(area, scene_of(rig));
  const auto cells = static_cast<double>(grid.columns * grid.rows);
  EXPECT_NEAR(static_cast<double>(grid.points()) / cells * grid.width * grid.height,
              0.5 * 2.0 * std::sqrt(2.0), 0.1);
  for (const auto& at : grid.position) EXPECT_NEAR(at.z - 0.5, at.y - 1.0, 1e-9);
  EXPECT_NEAR(glm::length(grid.normal - glm::normalize(Vec3d(0, -1, 1))), 0.0, 1e-9);
}

}  // namespace
}  // namespace luxel
