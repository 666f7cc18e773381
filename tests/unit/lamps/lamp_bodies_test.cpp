// SPDX-License-Identifier: Apache-2.0
#include "luxel/lamps/lamp_bodies.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "luxel/patch/make_patches.h"

#include "support/truth_scenes.h"

namespace luxel {
namespace {

PatchSet lamps_over_a_floor() {
  truth::SceneBuilder builder;
  builder.material("floor", 0.5f, 0.0f).quad({-4, -4, 0}, {4, -4, 0}, {4, 4, 0}, {-4, 4, 0});
  builder.material("dim", 0.0f, 10.0f).quad({2, 0, 2}, {2, 1, 2}, {3, 1, 2}, {3, 0, 2});
  builder.material("bright", 0.0f, 100.0f).quad({0, 0, 2}, {0, 1, 2}, {1, 1, 2}, {1, 0, 2});
  builder.material("faint", 0.0f, 1.0f).quad({-3, 0, 2}, {-3, 1, 2}, {-2, 1, 2}, {-2, 0, 2});
  builder.material("wide", 0.0f, 100.0f).quad({-4, -4, 3}, {-4, 0, 3}, {4, 0, 3}, {4, -4, 3});
  return make_patches(builder.scene(), {.max_edge = no_max_edge, .contacts = false});
}

TEST(LampBodies, are_the_small_lamps_by_flux) {
  const auto bodies = find_lamp_bodies(lamps_over_a_floor(), 10);
  ASSERT_EQ(bodies.size(), 2u) << "neither the one that is as large as the room, nor the faint one";
  EXPECT_NEAR(glm::distance(bodies[0].centre.light.position, Vec3(0.5f, 0.5f, 2.0f)), 0.0f, 1e-6f);
  EXPECT_NEAR(glm::distance(bodies[1].centre.light.position, Vec3(2.5f, 0.5f, 2.0f)), 0.0f, 1e-6f);
  for (const auto& body : bodies) {
    EXPECT_EQ(body.vertices.size(), 4u);
    EXPECT_NEAR(body.radius, std::sqrt(0.5), 1e-6);
  }
  EXPECT_NEAR(bodies[0].centre.intensity[1], 100.0 / (2.0 * std::numbers::pi), 1e-4);
  EXPECT_EQ(find_lamp_bodies(lamps_over_a_floor(), 1).size(), 1u);
}

TEST(LampBodies, a_scene_without_lamps_has_none) {
  truth::SceneBuilder builder;
  builder.material("floor", 0.5f, 0.0f).quad({-4, -4, 0}, {4, -4, 0}, {4, 4, 0}, {-4, 4, 0});
  const auto floor = make_patches(builder.scene(), {.max_edge = no_max_edge, .contacts = false});
  EXPECT_TRUE(find_lamp_bodies(floor, 10).empty());
}

}  // namespace
}  // namespace luxel
