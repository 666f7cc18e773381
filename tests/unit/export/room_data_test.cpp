// SPDX-License-Identifier: Apache-2.0
// Outlines and areas of rooms with known shapes.
#include "luxel/export/room_data.h"

#include <cmath>

#include <gtest/gtest.h>

#include "luxel/export/floor_outline.h"
#include "luxel/export/lighting_report.h"
#include "luxel/patch/make_patches.h"

#include "support/truth_scenes.h"

namespace luxel {
namespace {

// A floor in the shape of an L of two rectangles, 4 x 2 m and 2 x 3 m, with a wall of 3 m at y = 0.
PatchSet room_of_l_shape() {
  truth::SceneBuilder b;
  b.material("floor", 0.2f, 0.0f)
      .quad({0, 0, 0}, {4, 0, 0}, {4, 2, 0}, {0, 2, 0})
      .quad({0, 2, 0}, {2, 2, 0}, {2, 5, 0}, {0, 5, 0})
      .material("wall", 0.5f, 0.0f)
      .quad({0, 0, 0}, {0, 0, 3}, {4, 0, 3}, {4, 0, 0});
  return make_patches(b.scene(), {.max_edge = 0.4f});
}

TEST(RoomData, finds_the_outline_of_an_l) {
  const auto room = find_room_data(room_of_l_shape(), {0.0f, 0.0f, 1.0f});
  ASSERT_EQ(room.outline.size(), 1u);
  EXPECT_EQ(room.outline[0].size(), 6u);
  EXPECT_NEAR(room.floor_area, 14.0, 1e-5);
  EXPECT_NEAR(room.high.z - room.low.z, 3.0, 1e-5);
  EXPECT_TRUE(contains(room.outline[0], {1.0, 4.0}));
  EXPECT_FALSE(contains(room.outline[0], {3.0, 4.0}));
  EXPECT_NEAR(distance_from(room.outline[0], {3.0, 1.5}), 0.5, 1e-5);
  EXPECT_FALSE(room.walls.empty());
  ASSERT_EQ(room.materials.size(), 2u);
  EXPECT_NEAR(room.materials[0].area, 14.0, 1e-4);
  EXPECT_NEAR(room.materials[0].reflectance, 0.2, 1e-6);
  EXPECT_NEAR(room.materials[1].area, 12.0, 1e-4);
}

TEST(RoomData, a_scene_without_a_floor_has_the_rectangle_around_it) {
  truth::SceneBuilder b;
  b.material("wall", 0.5f, 0.0f).quad({0, 0, 0}, {0, 1, 3}, {4, 1, 3}, {4, 0, 0});
  const auto room = find_room_data(make_patches(b.scene(), {.max_edge = 1.0f}), {0.0f, 0.0f, 1.0f});
  EXPECT_NEAR(room.floor_area, 4.0, 1e-5);
}

// Where y is up, the sheet shows x to the right and -z upwards, so that nothing is mirrored.
TEST(PlanAxes, are_right_handed_for_both_up_axes) {
  for (const auto& up : {Vec3d(0.0, 0.0, 1.0), Vec3d(0.0, 1.0, 0.0), Vec3d(1.0, 0.0, 0.0)}) {
    const auto axes = plan_axes(up);
    EXPECT_NEAR(glm::length(glm::cross(axes.right, axes.ahead) - up), 0.0, 1e-12);
    const Vec3d point(1.0, 2.0, 3.0);
    EXPECT_NEAR(glm::length(axes.in_scene(axes.in_plan(point)) - point), 0.0, 1e-12);
  }
  EXPECT_EQ(plan_axes({0.0, 1.0, 0.0}).ahead, Vec3d(0.0, 0.0, -1.0));
}

// In an L the middle of the bounding rectangle's right side is a corner: observers are at walls that exist.
TEST(WallObservers, are_inside_of_the_room) {
  const auto room = find_room_data(room_of_l_shape(), {0.0f, 0.0f, 1.0f});
  const auto observers = wall_observers(room, 1.2);
  ASSERT_EQ(observers.size(), 4u);
  for (const auto& o : observers) {
    EXPECT_TRUE(contains(room.outline[0], {o.place.eye.x, o.place.eye.y})) << o.place.name;
    EXPECT_NEAR(distance_from(room.outline[0], {o.place.eye.x, o.place.eye.y}), 0.1, 1e-5);
    EXPECT_NEAR(o.place.eye.z, 1.2, 1e-6);
  }
  EXPECT_NEAR(observers[1].place.eye.y, 1.0, 1e-5) << "the right wall is 2 m long";
  EXPECT_NEAR(observers[2].place.eye.x, 1.0, 1e-5) << "the upper wall is 2 m long";
}

}  // namespace
}  // namespace luxel
