// SPDX-License-Identifier: Apache-2.0
#include "scenes/places/reading_room.h"

#include <set>
#include <string>

#include <gtest/gtest.h>

#include "scenes/places/reading_room_shell.h"
#include "scenes/scene_list.h"
#include "support/mesh_topology.h"

namespace luxel::scenes {
namespace {

const std::vector<Object>& room() {
  static const auto objects = reading_room();
  return objects;
}

bool shines(Paint paint) { return shines(palette()[static_cast<std::size_t>(paint)]); }

Vec3d middle(const Mesh& mesh) {
  auto sum = Vec3d(0.0);
  for (const auto& p : mesh.points) sum += p;
  return sum / static_cast<double>(mesh.points.size());
}

TEST(ReadingRoom, has_between_ten_and_forty_thousand_triangles) {
  auto triangles = std::size_t{0};
  for (const auto& object : room()) triangles += object.mesh.triangles.size();
  EXPECT_GE(triangles, 10'000u);
  EXPECT_LE(triangles, 40'000u);
}

TEST(ReadingRoom, cuts_every_triangle_in_detail_squared_on_request) {
  const auto fine = reading_room(3);
  ASSERT_EQ(fine.size(), room().size());
  for (std::size_t i = 0; i < fine.size(); ++i) {
    const auto& object = fine[i];
    ASSERT_EQ(object.mesh.triangles.size(), 9 * room()[i].mesh.triangles.size()) << object.name;
    for (const auto& triangle : object.mesh.triangles)
      ASSERT_GT(glm::length(area_vector(object.mesh, triangle)), 1e-9) << object.name;  // m²
    if (object.closed) {
      EXPECT_EQ(open_edges(object.mesh), 0) << object.name;
      // Points are rounded to a micrometre, on either side of the old surface.
      EXPECT_NEAR(enclosed_volume(object.mesh), enclosed_volume(room()[i].mesh), 1e-6) << object.name;
    }
  }
}

TEST(ReadingRoom, turns_walls_floors_and_ceilings_into_their_rooms) {
  for (const auto& object : room()) {
    const auto in_corridor = object.name.starts_with("corridor_");
    const auto is_shell = object.name.starts_with("wall_") || object.name == "floor" ||
                          object.name == "ceiling" || object.name.starts_with("corridor_wall") ||
                          object.name == "corridor_floor" || object.name == "corridor_ceiling";
    if (!is_shell) continue;
    const auto inside = in_corridor ? 0.5 * (corridor_low + corridor_high) : 0.5 * (room_low + room_high);
    for (const auto& triangle : object.mesh.triangles) {
      const auto towards = inside - centroid(object.mesh, triangle);
      EXPECT_GT(glm::dot(area_vector(object.mesh, triangle), towards), 0.0) << object.name;
    }
  }
}

TEST(ReadingRoom, turns_every_lamp_outwards_and_the_window_into_the_room) {
  auto lamps = std::set<Paint>{};
  for (const auto& object : room()) {
    const auto center = middle(object.mesh);
    for (const auto& triangle : object.mesh.triangles) {
      if (!shines(triangle.paint)) continue;
      lamps.insert(triangle.paint);
      const auto front = area_vector(object.mesh, triangle);
      const auto is_window = object.name.starts_with("window_");
      const auto outwards = is_window ? Vec3d(0.0, 0.0, 1.0) : centroid(object.mesh, triangle) - center;
      EXPECT_GT(glm::dot(front, outwards), 0.0) << object.name;
    }
  }
  EXPECT_EQ(lamps.size(), 15u) << "six paints of lamps, eight of the sky, one of the town";
}

TEST(ReadingRoom, fills_the_room_and_the_corridor_and_nothing_beyond) {
  auto low = room_high;
  auto high = room_low;
  for (const auto& object : room()) {
    for (const auto& p : object.mesh.points) {
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
  }
  EXPECT_EQ(low, glm::min(room_low, corridor_low));
  EXPECT_EQ(high, glm::max(room_high, corridor_high));
}

TEST(ReadingRoom, stands_each_camera_in_the_room) {
  for (const auto& view : make_scene("reading-room").views) {
    EXPECT_TRUE(glm::all(glm::greaterThan(view.eye, room_low)) &&
                glm::all(glm::lessThan(view.eye, room_high)))
        << view.name;
  }
}

TEST(ReadingRoom, has_the_triangles_that_benchmarks_count_on) {
  auto triangles = std::size_t{0};
  for (const auto& object : room()) triangles += object.mesh.triangles.size();
  EXPECT_EQ(triangles, 39'884u) << "bench/accuracy_sections.cpp has this number";
}

}  // namespace
}  // namespace luxel::scenes
