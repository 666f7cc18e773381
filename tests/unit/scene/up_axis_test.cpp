// SPDX-License-Identifier: Apache-2.0
#include "luxel/scene/up_axis.h"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

namespace luxel {
namespace {

const Vec3 y_up(0.0f, 1.0f, 0.0f);
const Vec3 z_up(0.0f, 0.0f, 1.0f);

// A scene made of boxes and rectangles, y up; turned() stands it on z.
struct Model {
  Scene scene;

  Model() {
    scene.source = "model";
    scene.groups = {"default"};
    scene.materials.resize(2);
    scene.materials[0].name = "surface";
    scene.materials[1].name = "source";
    scene.materials[1].emittance = Vec3(10.0f);
  }

  void quad(const Vec3& at, const Vec3& a, const Vec3& b, std::uint32_t group = 0,
            std::uint32_t material = 0) {
    const auto first = static_cast<std::uint32_t>(scene.positions.size());
    for (const auto& p : {at, at + a, at + a + b, at + b}) scene.positions.push_back(p);
    for (const auto& t : {std::array{0u, 1u, 2u}, std::array{0u, 2u, 3u}}) {
      scene.triangles.push_back({first + t[0], first + t[1], first + t[2]});
      scene.triangle_material.push_back(MaterialId{material});
      scene.triangle_line.push_back(0);
      scene.triangle_group.push_back(group);
    }
  }
  // Turned about y by an angle with this tangent; fronts outwards.
  void box(const Vec3& low, const Vec3& size, float tangent = 0.0f) {
    const auto u = glm::normalize(Vec3(1.0f, 0.0f, tangent)), v = Vec3(-u.z, 0.0f, u.x);
    const Vec3 x = size.x * u, y(0.0f, size.y, 0.0f), z = size.z * v;
    quad(low, x, z);
    quad(low + y, z, x);
    quad(low, y, x);
    quad(low + z, x, y);
    quad(low, z, y);
    quad(low + x, y, z);
  }
  Scene turned() const {
    auto other = scene;
    for (auto& p : other.positions) p = {p.x, -p.z, p.y};
    return other;
  }
};

void expect_y(const Model& model) {
  EXPECT_EQ(up_axis(model.scene), y_up);
  EXPECT_EQ(up_axis(model.turned()), z_up);
}

TEST(UpAxis, of_a_furnished_room) {
  Model room;
  room.box({0, 0, 0}, {5, 2.5f, 4});
  for (int i = 0; i < 3; ++i) room.box({1.0f + static_cast<float>(i), 0, 1}, {0.5f, 0.5f, 0.5f}, 0.3f);
  room.box({1, 0.7f, 2}, {1.6f, 0.05f, 0.8f});
  expect_y(room);
}

TEST(UpAxis, of_a_tall_atrium_with_balconies) {
  Model atrium;
  atrium.box({0, 0, 0}, {12, 30, 10});
  for (int level = 1; level < 8; ++level) {
    atrium.box({0, 3.5f * static_cast<float>(level), 0}, {1.5f, 0.3f, 10});
    atrium.box({10.5f, 3.5f * static_cast<float>(level), 0}, {1.5f, 0.3f, 10});
  }
  expect_y(atrium);
}

TEST(UpAxis, of_an_empty_shaft) {
  Model shaft;
  shaft.box({0, 0, 0}, {3, 20, 3});
  expect_y(shaft);
}

TEST(UpAxis, of_terrain) {
  Model terrain;
  const auto height = [](int i, int k) {
    return 3.0f * static_cast<float>((i * 7 + k * 13) % 11) / 11.0f + 0.4f * static_cast<float>(i % 5);
  };
  for (int i = 0; i < 12; ++i)
    for (int k = 0; k < 12; ++k) {
      const Vec3 at(10.0f * static_cast<float>(i), height(i, k), 10.0f * static_cast<float>(k));
      terrain.quad(at, Vec3(0, height(i, k + 1) - at.y, 10), Vec3(10, height(i + 1, k) - at.y, 0));
    }
  expect_y(terrain);
}

TEST(UpAxis, of_a_single_table) {
  Model table;
  table.box({0, 0.7f, 0}, {1.6f, 0.04f, 0.8f});
  for (const float x : {0.0f, 1.54f})
    for (const float z : {0.0f, 0.74f}) table.box({x, 0, z}, {0.06f, 0.7f, 0.06f});
  expect_y(table);
}

TEST(UpAxis, of_a_cube_with_lamps_on_the_ceiling) {
  Model room;
  room.box({0, 0, 0}, {3, 3, 3});
  for (int i = 0; i < 2; ++i) {
    const auto at = 0.5f + static_cast<float>(i);
    room.quad({at, 2.9f, 1}, {0.5f, 0, 0}, {0, 0, 0.5f}, 0, 1);
  }
  expect_y(room);
}

TEST(UpAxis, of_a_cube_is_y) {
  Model cube;
  cube.box({0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(up_axis(cube.scene), y_up);
}

TEST(UpAxis, of_a_room_without_front_wall) {
  Model room;
  room.quad({0, 0, 0}, {0, 0, 5}, {5, 0, 0});
  room.quad({0, 5, 0}, {5, 0, 0}, {0, 0, 5});
  room.quad({0, 0, 0}, {5, 0, 0}, {0, 5, 0});
  room.quad({0, 0, 0}, {0, 5, 0}, {0, 0, 5});
  room.quad({5, 0, 0}, {0, 0, 5}, {0, 5, 0});
  room.box({1, 0, 1}, {1.5f, 1.5f, 1.5f}, 0.3f);
  expect_y(room);
}

TEST(UpAxis, of_a_house_with_a_pitched_roof_along_either_axis) {
  for (const bool along_x : {false, true}) {
    Model house;
    house.box({0, 0, 0}, {10, 3, 10});
    const Vec3 ridge = along_x ? Vec3(10, 0, 0) : Vec3(0, 0, 10);
    const Vec3 across = along_x ? Vec3(0, 0, 5) : Vec3(5, 0, 0);
    house.quad({0, 3, 0}, ridge, across + Vec3(0, 3, 0));
    house.quad(Vec3(0, 3, 0) + 2.0f * across, ridge, -across + Vec3(0, 3, 0));
    expect_y(house);
  }
}

TEST(UpAxis, names_of_floors_and_ceilings_decide) {
  for (const bool is_floor : {true, false}) {
    Model corridor;
    corridor.scene.groups = {"default", "Floor_01"};
    corridor.box({0, 0, 0}, {20, 3, 2});
    if (is_floor)
      corridor.quad({0, 0, 0}, {0, 0, 2}, {20, 0, 0}, 1);
    else
      corridor.quad({0, 0, 0}, {0, 3, 0}, {20, 0, 0}, 1);
    EXPECT_EQ(up_axis(corridor.scene), is_floor ? y_up : z_up);
  }
}

TEST(UpAxis, does_not_depend_on_the_scale_or_the_order) {
  Model room;
  room.box({0, 0, 0}, {5, 2.5f, 4});
  room.box({1, 0, 1}, {0.5f, 0.5f, 0.5f}, 0.3f);
  auto other = room.scene;
  for (auto& p : other.positions) p *= 1000.0f;
  std::reverse(other.triangles.begin(), other.triangles.end());
  EXPECT_EQ(up_axis(other), up_axis(room.scene));
}

}  // namespace
}  // namespace luxel
