// SPDX-License-Identifier: Apache-2.0
#include "luxel/lamps/luminaire_check.h"

#include <gtest/gtest.h>

#include "luxel/patch/make_patches.h"
#include "luxel/photometry/opening.h"
#include "luxel/trace/point_sight.h"

#include "support/luminaires.h"
#include "support/truth_scenes.h"

namespace luxel {
namespace {

const LuminousOpening box{OpeningShape::box, {0.2, 0.1, 0.08}};

// The unit cube, closed, with a luminaire at its middle and at a height.
Scene cube_with(const LuminousOpening& opening, float height,
                IntensityDistribution distribution = test::cosine_distribution(100.0)) {
  auto scene = truth::cube({});
  scene.point_lights.push_back(test::luminaire(std::move(distribution), opening, {0.5f, 0.5f, height}));
  return scene;
}

std::vector<LuminaireFault> faults_of(const Scene& scene) {
  const auto patches = make_patches(scene, {.max_edge = no_max_edge});
  return find_luminaire_faults(patches, Tracer(patches, Context(1)));
}

double moved_height(Scene scene) {
  move_luminaires_free(scene, Context(1));
  return static_cast<double>(scene.point_lights[0].position.z);
}

TEST(LuminaireCheck, a_luminaire_below_the_ceiling_is_fine) {
  for (const float height : {0.5f, 0.96f}) EXPECT_TRUE(faults_of(cube_with(box, height)).empty()) << height;
  EXPECT_TRUE(faults_of(cube_with({OpeningShape::rectangle, {0.2, 0.1, 0.0}}, 1.0f)).empty());
}

TEST(LuminaireCheck, one_that_reaches_through_the_ceiling_is_moved_below_it) {
  for (const float height : {0.98f, 1.0f, 1.03f}) {
    const auto scene = cube_with(box, height);
    const auto faults = faults_of(scene);
    ASSERT_EQ(faults.size(), 1u) << height;
    EXPECT_EQ(faults[0].kind, LuminaireFault::Kind::crosses);
    EXPECT_NEAR(moved_height(scene), 0.96, 1e-5) << height;
  }
}

TEST(LuminaireCheck, one_that_shines_upwards_is_moved_above_the_floor_that_crosses_it) {
  std::vector<double> gamma, values;
  for (int i = 0; i <= 180; ++i) {
    gamma.push_back(i);
    values.push_back(i > 90 ? 100.0 : 0.0);
  }
  const IntensityDistribution up{GoniometerType::c, gamma, {0.0}, values};
  EXPECT_NEAR(moved_height(cube_with(box, 0.01f, up)), 0.04, 1e-5);
}

TEST(LuminaireCheck, one_right_behind_the_ceiling_is_reported_and_not_moved) {
  const auto scene = cube_with({OpeningShape::rectangle, {0.2, 0.1, 0.0}}, 1.02f);
  const auto faults = faults_of(scene);
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].kind, LuminaireFault::Kind::hides);
  EXPECT_NEAR(faults[0].move.z, -0.02, 1e-5);
  EXPECT_NEAR(moved_height(scene), 1.02, 1e-6);
  const auto patches = make_patches(scene, {.max_edge = no_max_edge});
  const auto groups = group_faults(patches, faults);
  ASSERT_EQ(groups.size(), 1u);
  EXPECT_EQ(groups[0].remedy, "move it by 20 mm, before it");
  EXPECT_NE(groups[0].fact.find("a luminaire of 'test.ies' lies 20 mm behind a surface of '"),
            std::string::npos)
      << groups[0].fact;
}

// The model of a housing is no wider than the opening.
TEST(LuminaireCheck, a_model_of_the_luminaire_does_no_harm) {
  auto scene = cube_with(box, 0.5f);
  truth::SceneBuilder b;
  b.material("housing", 0.5f, 0.0f);
  b.quad({0.42f, 0.46f, 0.5f}, {0.58f, 0.46f, 0.5f}, {0.58f, 0.54f, 0.5f}, {0.42f, 0.54f, 0.5f});
  auto with_model = b.scene();
  with_model.point_lights = scene.point_lights;
  EXPECT_TRUE(faults_of(with_model).empty());
}

TEST(LuminaireSight, a_point_that_the_luminaire_covers_gets_nothing_and_rays_end_before_the_opening) {
  const auto light = test::luminaire(test::cosine_distribution(100.0), box, {0.5f, 0.5f, 1.0f});
  for (int i = 0; i < 64; ++i) {
    const std::array<double, 2> u = {(i + 0.5) / 64.0, std::fmod(0.618 * i, 1.0)};
    EXPECT_EQ(sight_of(light, {0.55, 0.5, 1.0}, {0, 0, 1}, u).irradiance, 0.0);
    const auto below = sight_of(light, {0.5, 0.5, 0.0}, {0, 0, 1}, u);
    EXPECT_GT(below.irradiance, 0.0);
    // The nearest point of the box is 0.96 m above; no ray comes as near as the recess.
    EXPECT_LT(below.distance * below.direction.z, 0.96 - 0.9 * recess);
    EXPECT_GT(below.distance * below.direction.z, 0.96 - 1.1 * recess);
  }
}

TEST(LuminaireOpening, holds_the_points_that_are_in_its_body) {
  const LuminousOpening cylinder{OpeningShape::vertical_cylinder, {0.2, 0.2, 0.1}};
  EXPECT_TRUE(holds(cylinder, {0.09, 0.0, 0.04}, 0.0));
  EXPECT_FALSE(holds(cylinder, {0.08, 0.08, 0.0}, 0.0));
  EXPECT_TRUE(holds(cylinder, {0.0, 0.0, 0.054}, 0.005));
  EXPECT_FALSE(holds(cylinder, {0.0, 0.0, 0.056}, 0.005));
  EXPECT_FALSE(holds({OpeningShape::ellipsoid, {0.2, 0.2, 0.2}}, {0.07, 0.07, 0.07}, 0.0));
  EXPECT_FALSE(holds({}, {0.0, 0.0, 0.0}, 1.0));
}

}  // namespace
}  // namespace luxel
