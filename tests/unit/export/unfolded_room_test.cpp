// SPDX-License-Identifier: Apache-2.0
// The unfolded room: which faces it has, and where they lie.
#include "luxel/export/unfolded_room.h"

#include <cmath>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "luxel/patch/make_patches.h"

#include "support/truth_scenes.h"

namespace luxel {
namespace {

// 4 x 2 x 3 m; without the wall at y = 0.
PatchSet open_room() {
  truth::SceneBuilder b;
  b.material("all", 0.5f, 0.0f)
      .quad({0, 0, 0}, {4, 0, 0}, {4, 2, 0}, {0, 2, 0})
      .quad({0, 0, 3}, {0, 2, 3}, {4, 2, 3}, {4, 0, 3})
      .quad({4, 0, 0}, {4, 0, 3}, {4, 2, 3}, {4, 2, 0})
      .quad({0, 2, 0}, {4, 2, 0}, {4, 2, 3}, {0, 2, 3})
      .quad({0, 0, 0}, {0, 2, 0}, {0, 2, 3}, {0, 0, 3});
  return make_patches(b.scene(), {.max_edge = 0.5f});
}

TEST(UnfoldedRoom, has_the_faces_that_surfaces_cover_with_points_before_them) {
  const auto patches = open_room();
  const auto room = find_room_data(patches, {0.0, 0.0, 1.0});
  const auto faces = faces_of(room, patches);
  std::map<std::string, Vec3d> normals;
  for (const auto& face : faces) {
    normals[face.area.name] = *face.area.normal;
    for (const auto& corner : face.area.polygon)
      EXPECT_LE(std::abs(corner.x - 2.0), 2.0 + 1e-6) << face.area.name;
  }
  EXPECT_EQ(normals.size(), 5u);
  EXPECT_EQ(normals.count("lower wall"), 0u);
  EXPECT_NEAR(glm::length(normals["floor"] - Vec3d(0, 0, 1)), 0.0, 1e-9);
  EXPECT_NEAR(glm::length(normals["ceiling"] - Vec3d(0, 0, -1)), 0.0, 1e-9);
  EXPECT_NEAR(glm::length(normals["left wall"] - Vec3d(1, 0, 0)), 0.0, 1e-9);
  EXPECT_NEAR(glm::length(normals["upper wall"] - Vec3d(0, -1, 0)), 0.0, 1e-9);
}

TEST(UnfoldedRoom, is_empty_where_the_floor_is_no_rectangle) {
  truth::SceneBuilder b;
  b.material("floor", 0.2f, 0.0f)
      .quad({0, 0, 0}, {4, 0, 0}, {4, 2, 0}, {0, 2, 0})
      .quad({0, 2, 0}, {2, 2, 0}, {2, 5, 0}, {0, 5, 0})
      .quad({0, 0, 0}, {0, 0, 3}, {4, 0, 3}, {4, 0, 0});
  const auto patches = make_patches(b.scene(), {.max_edge = 0.5f});
  EXPECT_TRUE(faces_of(find_room_data(patches, {0.0, 0.0, 1.0}), patches).empty());
}

// One point at a known place of each wall lies outside of the floor's rectangle on its own side.
TEST(UnfoldedRoom, lays_walls_down_around_the_floor) {
  const auto patches = open_room();
  const auto room = find_room_data(patches, {0.0, 0.0, 1.0});
  UnfoldedRoom measured;
  for (const auto& face : faces_of(room, patches)) {
    PlaneResult result;
    result.area = face.area;
    result.grid.corner = 0.5 * (face.area.polygon[0] + face.area.polygon[2]);
    result.grid.along = glm::normalize(face.area.polygon[1] - face.area.polygon[0]);
    result.grid.across = glm::cross(*face.area.normal, result.grid.along);
    result.grid.width = result.grid.height = 0.01;
    result.grid.cell = {0};
    result.grid.position = {result.grid.corner};
    result.light.resize(1);
    result.light[0].illuminance = 100.0 + static_cast<double>(measured.size());
    measured.push_back({face, result});
  }
  const auto svg = unfolded_svg(measured, room);
  const auto place = [&](const std::string& name) {
    const auto end = svg.find(">" + name + "<");
    const auto begin = svg.rfind("<text x=\"", end);
    return Vec2d(std::stod(svg.substr(begin + 9)), std::stod(svg.substr(svg.find("y=\"", begin) + 3)));
  };
  const auto floor = place("floor");
  EXPECT_LT(place("left wall").x, floor.x);
  EXPECT_GT(place("right wall").x, floor.x);
  EXPECT_NEAR(place("left wall").y, floor.y, 0.2);
  EXPECT_LT(place("upper wall").y, floor.y);
  EXPECT_LT(place("ceiling").y, place("upper wall").y);
  // The scale: 2 m of floor and 3 m of wall lie between the middles of floor and ceiling, 2 + 3 m; left and
  // right walls are 4 + 3 m apart.
  EXPECT_NEAR((floor.y - place("ceiling").y) / (place("right wall").x - place("left wall").x), 5.0 / 7.0,
              0.01);
}

}  // namespace
}  // namespace luxel
