// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "showpiece/room.h"
#include "showpiece/shell.h"
#include "showpiece/write_obj.h"

namespace luxel::showpiece {
namespace {

const std::vector<Object>& room() {
  static const auto objects = reading_room();
  return objects;
}

bool shines(Paint paint) { return shines(palette()[static_cast<std::size_t>(paint)]); }

// Edges that do not have exactly one triangle on each side, running opposite ways.
int open_edges(const Mesh& mesh) {
  auto count = std::map<std::pair<std::uint32_t, std::uint32_t>, int>{};
  for (const auto& [corners, paint] : mesh.triangles) {
    for (auto k = 0u; k < 3; ++k) ++count[{corners[k], corners[(k + 1) % 3]}];
  }
  return static_cast<int>(std::count_if(count.begin(), count.end(), [&](const auto& edge) {
    const auto back = count.find({edge.first.second, edge.first.first});
    return edge.second != 1 || back == count.end() || back->second != 1;
  }));
}

// Gauss's theorem: positive where the faces look outwards. m³.
double enclosed_volume(const Mesh& mesh) {
  auto volume = 0.0;
  for (const auto& triangle : mesh.triangles) {
    volume += glm::dot(centroid(mesh, triangle), area_vector(mesh, triangle)) / 3.0;
  }
  return volume;
}

Vec3d middle(const Mesh& mesh) {
  auto sum = Vec3d(0.0);
  for (const auto& p : mesh.points) sum += p;
  return sum / static_cast<double>(mesh.points.size());
}

std::string bytes_of(const std::filesystem::path& path) {
  auto text = std::ostringstream{};
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

TEST(Showpiece, has_between_ten_and_forty_thousand_triangles) {
  auto triangles = std::size_t{0};
  for (const auto& object : room()) triangles += object.mesh.triangles.size();
  EXPECT_GE(triangles, 10'000u);
  EXPECT_LE(triangles, 40'000u);
}

TEST(Showpiece, cuts_every_triangle_in_detail_squared_on_request) {
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

TEST(Showpiece, gives_every_triangle_area) {
  for (const auto& object : room()) {
    for (const auto& triangle : object.mesh.triangles) {
      ASSERT_GT(glm::length(area_vector(object.mesh, triangle)), 1e-8) << object.name;  // m²: 0.1 mm square
    }
  }
}

TEST(Showpiece, bounds_each_closed_thing_on_all_sides_with_its_faces_outwards) {
  for (const auto& object : room()) {
    if (!object.closed) continue;
    EXPECT_EQ(open_edges(object.mesh), 0) << object.name;
    EXPECT_GT(enclosed_volume(object.mesh), 0.0) << object.name;
  }
}

TEST(Showpiece, leaves_no_two_triangles_in_one_place) {
  using Corner = std::array<double, 3>;
  auto seen = std::set<std::array<Corner, 3>>{};
  for (const auto& object : room()) {
    for (const auto& triangle : object.mesh.triangles) {
      auto key = std::array<Corner, 3>{};
      for (auto k = 0u; k < 3; ++k) {
        const auto& p = object.mesh.points[triangle.corners[k]];
        key[k] = {p.x, p.y, p.z};
      }
      std::sort(key.begin(), key.end());
      EXPECT_TRUE(seen.insert(key).second) << object.name;
    }
  }
}

TEST(Showpiece, turns_walls_floors_and_ceilings_into_their_rooms) {
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

TEST(Showpiece, turns_every_lamp_outwards_and_the_window_into_the_room) {
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
  const auto shining =
      std::count_if(palette().begin(), palette().end(), [](const Pigment& p) { return shines(p); });
  EXPECT_EQ(lamps.size(), static_cast<std::size_t>(shining)) << "each shining paint is on some lamp";
}

TEST(Showpiece, fills_the_room_and_the_corridor_and_nothing_beyond) {
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

TEST(Showpiece, paints_with_reflectances_below_one_under_names_of_their_own) {
  auto names = std::set<std::string>{};
  for (const auto& pigment : palette()) {
    EXPECT_EQ(&pigment - palette().data(), static_cast<int>(pigment.paint)) << pigment.name;
    EXPECT_TRUE(names.insert(pigment.name).second) << pigment.name;
    for (auto band = 0; band < 3; ++band) {
      EXPECT_GT(pigment.reflectance[band], 0.0f) << pigment.name;
      EXPECT_LT(pigment.reflectance[band], 0.9f) << pigment.name;
    }
  }
}

TEST(Showpiece, stands_each_camera_in_the_room) {
  for (const auto& view : views()) {
    EXPECT_TRUE(glm::all(glm::greaterThan(view.eye, room_low)) &&
                glm::all(glm::lessThan(view.eye, room_high)))
        << view.name;
  }
}

TEST(Showpiece, writes_the_same_bytes_twice) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "showpiece";
  write_reading_room(folder / "a" / "room.obj");
  write_reading_room(folder / "b" / "room.obj");
  const auto first = bytes_of(folder / "a" / "room.obj");
  EXPECT_GT(first.size(), 1'000'000u);
  EXPECT_EQ(first, bytes_of(folder / "b" / "room.obj"));
  EXPECT_NE(first.find("mtllib room.mtl\n"), std::string::npos);
  EXPECT_EQ(bytes_of(folder / "a" / "room.mtl"), bytes_of(folder / "b" / "room.mtl"));
}

TEST(Showpiece, is_at_detail_one_what_it_is_without) {
  EXPECT_EQ(obj_text(reading_room(1), views(), "room.mtl"), obj_text(room(), views(), "room.mtl"));
  auto triangles = std::size_t{0};
  for (const auto& object : room()) triangles += object.mesh.triangles.size();
  EXPECT_EQ(triangles, 39'884u) << "the help of luxel-showpiece says so";
}

}  // namespace
}  // namespace luxel::showpiece
