// SPDX-License-Identifier: Apache-2.0
// A gallery under a skylight, with wall washers on tracks.

#include <string>

#include "scenes/furniture/museum.h"
#include "scenes/places/places.h"
#include "scenes/shapes/dice.h"
#include "scenes/shapes/sheets.h"
#include "scenes/shapes/solids.h"
#include "scenes/shapes/sweeping.h"
#include "scenes/shapes/walls.h"

namespace luxel::scenes {
namespace {

constexpr auto on_floor = 0.001;

Room shell_of_gallery() {
  auto room = Room{.low = {-4.2, 0.0, -6.0}, .high = {4.2, 4.4, 6.0}, .thickness = 0.5};
  // Three skylights in a row along z.
  for (const auto z : {1.2, 4.6, 8.0})
    room.holes[ceiling_side].push_back({.left = 2.7, .right = 5.7, .low = z, .high = z + 2.8});
  return room;
}

// The wall across the room with a doorway to the second room.
void add_cross_wall(MadeScene& scene, const Room& room) {
  const auto size = room.high - room.low;
  const auto face = Face{{room.low.x, 0.0, -2.4}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, size.x, size.y};
  const auto doorway = std::vector<Hole>{{.left = 5.0, .right = 7.2, .low = 0.0, .high = 3.0}};
  auto wall = holed_face(face, doorway);
  const auto behind = Face{face.origin + Vec3d(size.x, 0.0, -0.3), -face.along, face.up, size.x, size.y};
  scene.add_open("cross_wall", painted(wall, Paint::plaster_white));
  scene.add_open(
      "cross_wall_behind",
      painted(holed_face(behind, {{.left = size.x - 7.2, .right = size.x - 5.0, .low = 0.0, .high = 3.0}}),
              Paint::terracotta_wall));
  scene.add_open("doorway", painted(reveals(face, doorway, 0.3, false), Paint::walnut));
}

void add_shell(MadeScene& scene, const Room& room) {
  auto parquet = room_floor(room, 0.5, 0.25);
  for (auto& triangle : parquet.triangles) {
    const auto p = centroid(parquet, triangle) - room.low;
    const auto row = static_cast<std::uint64_t>(p.z / 0.25);
    const auto board = static_cast<std::uint64_t>((p.x + 1.5 * dice(140, row)) / 1.5);
    constexpr Paint oaks[] = {Paint::floor_oak_2, Paint::floor_oak_4, Paint::floor_oak_1, Paint::floor_oak_4};
    triangle.paint = oaks[static_cast<std::size_t>(4.0 * dice(141, row, board))];
  }
  scene.add_open("floor", parquet);
  scene.add_open("ceiling", painted(inner_wall(room, ceiling_side), Paint::plaster_white));
  scene.add_open("wall_back", painted(inner_wall(room, back_wall), Paint::terracotta_wall));
  scene.add_open("wall_right", painted(inner_wall(room, right_wall), Paint::plaster_white));
  scene.add_open("wall_front", painted(inner_wall(room, front_wall), Paint::plaster_white));
  scene.add_open("wall_left", painted(inner_wall(room, left_wall), Paint::plaster_white));
  scene.add_open("skylight_shafts", painted(all_reveals(room), Paint::plaster_white));
  scene.add_open("outside", painted(outside(room), Paint::concrete));
  // Bars across the skylights, in the upper half of the shafts.
  auto bars = Mesh{};
  for (const auto z : {1.2, 4.6, 8.0}) {
    const auto middle = Vec3d(0.0, room.high.y + 0.30, room.low.z + z + 1.4);
    append(bars,
           moved(turned_x(frame(2.87, 2.67, {{0.0, 0.0}, {0.06, 0.0}, {0.06, 0.08}, {0.0, 0.08}}), 90.0),
                 middle));
    for (const auto x : {-0.72, 0.0, 0.72})
      append(bars, placed(box({0.045, 0.07, 2.668}), middle + Vec3d(x, -0.075, 0.0)));
  }
  scene.add_closed("skylight_bars", painted(bars, Paint::painted_wood));
}

void add_painting(MadeScene& scene, int k, double width, double height, const Vec3d& at, double turn) {
  const auto name = "painting_" + std::to_string(k);
  scene.add_closed(name + "_frame", placed(painting_frame(width, height), at, turn));
  scene.add_open(name + "_canvas",
                 placed(painting_canvas(width, height, static_cast<std::uint64_t>(k)), at, turn));
}

void add_art(MadeScene& scene, const Room& room) {
  const auto left = room.low.x, right = room.high.x;
  add_painting(scene, 1, 1.50, 1.90, {left, 1.75, 3.2}, 90.0);
  add_painting(scene, 2, 2.20, 1.60, {left, 1.75, 0.4}, 90.0);
  add_painting(scene, 3, 1.00, 1.30, {right, 1.70, 4.0}, -90.0);
  add_painting(scene, 4, 1.00, 1.30, {right, 1.70, 2.4}, -90.0);
  add_painting(scene, 5, 1.70, 1.70, {right, 1.75, 0.0}, -90.0);
  add_painting(scene, 6, 1.60, 2.00, {-1.55, 1.80, -2.4}, 0.0);
  add_painting(scene, 7, 2.00, 1.50, {1.9, 1.75, room.low.z}, 0.0);
  add_painting(scene, 8, 1.20, 1.50, {left, 1.75, -4.4}, 90.0);
  const auto add_sculpture = [&](const char* name, const Mesh& sculpture, const Vec3d& at, double width,
                                 double height, double turn) {
    scene.add_closed(std::string(name) + "_plinth", placed(plinth(width, height), at));
    scene.add_closed(name, placed(sculpture, at + Vec3d(0.0, height + 0.001, 0.0), turn));
  };
  add_sculpture("knot", knot_sculpture(), {1.9, on_floor, -0.3}, 0.50, 1.00, 20.0);
  add_sculpture("figure", figure_sculpture(), {-2.3, on_floor, 1.9}, 0.46, 0.75, 40.0);
  add_sculpture("pebbles", stacked_sculpture(), {1.85, on_floor, -4.4}, 0.80, 0.35, 0.0);
  scene.add_closed("bench_1", placed(museum_bench(), {-0.3, on_floor, 2.5}, 90.0));
  scene.add_closed("bench_2", placed(museum_bench(), {-2.2, on_floor, -4.3}, 90.0));
}

// A track along each long wall, 0.9 m before it, and three washers a painting's width apart.
void add_washers(MadeScene& scene, const Room& room) {
  auto housings = Mesh{};
  auto lamps = Mesh{};
  constexpr auto tilt = 38.0;
  const auto add = [&](const Vec3d& at, double turn) {
    append(housings, placed(washer_housing(tilt), at, turn));
    append(lamps, placed(washer_lamp(tilt), at, turn));
  };
  const auto y = room.high.y - 0.001;
  for (const auto z : {-5.2, -3.6, -1.4, 0.4, 2.0, 3.4, 4.8}) {
    add({room.low.x + 1.15, y, z}, -90.0);
    add({room.high.x - 1.15, y, z}, 90.0);
  }
  add({1.9, y, room.low.z + 1.15}, 180.0);
  add({-1.55, y, -1.25}, 180.0);
  scene.add_closed("washers", housings);
  scene.add_open("washer_lamps", lamps);
}

}  // namespace

MadeScene art_gallery() {
  auto scene = MadeScene{.title = "An art gallery under skylights, with wall washers", .sky = "2.0,2.5,3.2"};
  const auto room = shell_of_gallery();
  add_shell(scene, room);
  add_cross_wall(scene, room);
  add_art(scene, room);
  add_washers(scene, room);
  scene.views = {{"the first room", {3.1, 1.62, 5.55}, {-0.55, 1.62, -0.6}, 50.0},
                 {"through the doorway", {-0.6, 1.6, 1.4}, {1.75, 1.45, -4.4}, 46.0}};
  return scene;
}

}  // namespace luxel::scenes
