// SPDX-License-Identifier: Apache-2.0
#include "bench/scenes.h"

#include <cmath>

#include "bench/mesher.h"
#include "scenes/scene_list.h"
#include "scenes/to_scene.h"

namespace luxel::bench {
namespace {

// The scene with the cell width that gives about this number of triangles.
template <typename Make>
Scene with_triangles(std::size_t triangles, Make make) {
  float cell = 0.1f;
  auto scene = make(cell);
  for (int i = 0; i < 8; ++i) {
    const auto ratio = static_cast<float>(scene.triangles.size()) / static_cast<float>(triangles);
    if (std::abs(ratio - 1.0f) < 0.01f) break;
    cell *= std::sqrt(ratio);
    scene = make(cell);
  }
  return scene;
}

// A block on the floor without its bottom face: foot and top, each counter-clockwise seen from above.
void add_block(Mesher& mesher, const std::array<Vec2, 4>& foot, float height) {
  std::array<Vec3, 4> low;
  std::array<Vec3, 4> high;
  for (std::size_t k = 0; k < 4; ++k) {
    low[k] = {foot[k].x, 0.0f, foot[k].y};
    high[k] = {foot[k].x, height, foot[k].y};
  }
  mesher.quad(high[0], high[1], high[2], high[3]);
  for (std::size_t k = 0; k < 4; ++k) {
    const auto next = (k + 1) % 4;
    mesher.quad(low[k], low[next], high[next], high[k]);
  }
}

Scene cornell_box_of(float cell) {
  constexpr float x = 0.2764f, y = 0.5488f, z = -0.5592f;
  constexpr std::array<Vec3, 8> v = {Vec3{-x, 0, 0}, {x, 0, 0}, {x, y, 0}, {-x, y, 0},
                                     {-x, 0, z},     {x, 0, z}, {x, y, z}, {-x, y, z}};
  Mesher mesher(cell);
  mesher.material("white", Vec3(0.73f));
  mesher.quad(v[0], v[1], v[5], v[4]);  // floor
  mesher.quad(v[3], v[7], v[6], v[2]);  // ceiling
  mesher.quad(v[4], v[5], v[6], v[7]);  // back
  add_block(mesher, {Vec2{0.1464f, -0.0650f}, {0.1944f, -0.2250f}, {0.0364f, -0.2720f}, {-0.0136f, -0.1140f}},
            0.165f);
  add_block(mesher,
            {Vec2{-0.1466f, -0.2470f}, {0.0114f, -0.2960f}, {-0.0376f, -0.4560f}, {-0.1956f, -0.4060f}},
            0.33f);
  mesher.material("red", {0.61f, 0.06f, 0.05f});
  mesher.quad(v[0], v[4], v[7], v[3]);
  mesher.material("green", {0.12f, 0.44f, 0.10f});
  mesher.quad(v[1], v[2], v[6], v[5]);
  mesher.material("lamp", Vec3(0.78f), pi * Vec3(16.5f, 12.0f, 5.5f));
  constexpr float lamp = 0.5438f;
  mesher.quad({-0.065f, lamp, -0.227f}, {-0.065f, lamp, -0.332f}, {0.065f, lamp, -0.332f},
              {0.065f, lamp, -0.227f});
  return mesher.take();
}

constexpr float hair = 0.001f;  // m; nothing touches: no two faces in one place

void add_legs(Mesher& mesher, const Vec3& middle, const Vec2& half, float thickness, float height) {
  for (const float i : {-1.0f, 1.0f})
    for (const float j : {-1.0f, 1.0f}) {
      const Vec3 low(middle.x + i * half.x - 0.5f * thickness, middle.y + j * half.y - 0.5f * thickness,
                     hair);
      mesher.box(low, low + Vec3(thickness, thickness, height - 2.0f * hair));
    }
}

void add_workplace(Mesher& mesher, const Vec3& at) {
  mesher.material("desk", {0.45f, 0.33f, 0.20f});
  mesher.box(at + Vec3(-0.8f, -0.4f, 0.70f), at + Vec3(0.8f, 0.4f, 0.73f));
  mesher.material("steel", Vec3(0.35f));
  add_legs(mesher, at, {0.75f, 0.35f}, 0.05f, 0.70f);
  mesher.material("cloth", {0.12f, 0.20f, 0.45f});
  const auto chair = at + Vec3(0.0f, 0.75f, 0.0f);
  mesher.box(chair + Vec3(-0.24f, -0.22f, 0.44f), chair + Vec3(0.24f, 0.24f, 0.49f));
  mesher.box(chair + Vec3(-0.22f, 0.20f, 0.49f + hair), chair + Vec3(0.22f, 0.23f, 0.95f));
  mesher.material("steel", Vec3(0.35f));
  add_legs(mesher, chair, {0.20f, 0.19f}, 0.03f, 0.44f);
}

Scene office_of(float cell) {
  constexpr int columns = 4, rows = 3;
  constexpr float width = 12.0f, depth = 9.0f, height = 2.8f;
  Mesher mesher(cell);
  mesher.material("walls", {0.78f, 0.77f, 0.73f});
  mesher.box({0, 0, 0}, {width, depth, height}, true);
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < rows; ++j) {
      const Vec3 at(width / columns * (static_cast<float>(i) + 0.5f),
                    depth / rows * (static_cast<float>(j) + 0.45f), 0.0f);
      add_workplace(mesher, at);
      mesher.material("luminaire", Vec3(0.6f), Vec3(24.0f, 22.0f, 18.0f));
      const auto p = at + Vec3(0.0f, 0.2f, height - 0.05f);
      mesher.whole_quad(p + Vec3(-0.6f, -0.15f, 0), p + Vec3(-0.6f, 0.15f, 0), p + Vec3(0.6f, 0.15f, 0),
                        p + Vec3(0.6f, -0.15f, 0));
    }
  return mesher.take();
}

// The wall between the rooms seen from one of them, at x, with a hole for the door; `turn` if it faces +x.
struct Doorway {
  float low, high, top;  // m: along y, and up
};
void add_door_wall(Mesher& mesher, float x, float depth, float height, const Doorway& door, bool turn) {
  const auto strip = [&](float y0, float y1, float z0, float z1) {
    turn ? mesher.quad({x, y0, z0}, {x, y1, z0}, {x, y1, z1}, {x, y0, z1})
         : mesher.quad({x, y0, z0}, {x, y0, z1}, {x, y1, z1}, {x, y1, z0});
  };
  strip(0.0f, door.low, 0.0f, door.top);
  strip(door.high, depth, 0.0f, door.top);
  strip(0.0f, door.low, door.top, height);
  strip(door.low, door.high, door.top, height);
  strip(door.high, depth, door.top, height);
}

Scene two_rooms_of(float cell) {
  constexpr float width = 4.0f, depth = 3.6f, height = 2.6f, wall = 0.12f;
  constexpr float second = width + wall;
  constexpr Doorway door = {0.3f, 1.2f, 2.0f};
  Mesher mesher(cell);
  mesher.material("walls", {0.72f, 0.70f, 0.66f});
  // The shells of both rooms but for the walls between them.
  for (const float x : {0.0f, second}) {
    const auto end = x + width;
    mesher.quad({x, 0, 0}, {end, 0, 0}, {end, depth, 0}, {x, depth, 0});
    mesher.quad({x, 0, height}, {x, depth, height}, {end, depth, height}, {end, 0, height});
    mesher.quad({x, 0, 0}, {x, 0, height}, {end, 0, height}, {end, 0, 0});
    mesher.quad({x, depth, 0}, {end, depth, 0}, {end, depth, height}, {x, depth, height});
  }
  mesher.quad({0, 0, 0}, {0, depth, 0}, {0, depth, height}, {0, 0, height});
  constexpr float far = second + width;
  mesher.quad({far, 0, 0}, {far, 0, height}, {far, depth, height}, {far, depth, 0});
  add_door_wall(mesher, width, depth, height, door, false);
  add_door_wall(mesher, second, depth, height, door, true);
  // The sides of the doorway, its lintel and its threshold.
  const auto [low, high, top] = door;
  mesher.quad({width, low, 0}, {second, low, 0}, {second, high, 0}, {width, high, 0});
  mesher.quad({width, low, top}, {width, high, top}, {second, high, top}, {second, low, top});
  mesher.quad({width, low, 0}, {width, low, top}, {second, low, top}, {second, low, 0});
  mesher.quad({width, high, 0}, {second, high, 0}, {second, high, top}, {width, high, top});
  mesher.material("cupboards", {0.50f, 0.25f, 0.12f});
  mesher.box({1.2f, 2.9f, hair}, {2.4f, 3.5f, 1.8f});
  mesher.box({second + 2.6f, 0.4f, hair}, {second + 3.4f, 1.6f, 0.9f});
  mesher.material("lamp", Vec3(0.5f), Vec3(60.0f, 55.0f, 45.0f));
  const float z = height - 0.05f;
  mesher.quad({2.9f, 2.6f, z}, {2.9f, 3.1f, z}, {3.4f, 3.1f, z}, {3.4f, 2.6f, z});
  return mesher.take();
}

}  // namespace

Scene cornell_box(std::size_t triangles) { return with_triangles(triangles, cornell_box_of); }
Scene office(std::size_t triangles) { return with_triangles(triangles, office_of); }
Scene two_rooms(std::size_t triangles) { return with_triangles(triangles, two_rooms_of); }

Scene reading_room(int detail) {
  return scenes::to_scene(scenes::make_scene("reading-room", detail), "reading-room");
}

}  // namespace luxel::bench
