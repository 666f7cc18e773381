// SPDX-License-Identifier: Apache-2.0
#include "scenes/places/reading_room_shell.h"

#include <array>
#include <cmath>

#include "scenes/places/skyline.h"
#include "scenes/shapes/dice.h"
#include "scenes/shapes/sheets.h"
#include "scenes/shapes/solids.h"

namespace luxel::scenes {
namespace {

constexpr auto joint = 0.001;    // m; wood stands this far off walls and floor: no two faces in one place
constexpr auto wall_cell = 0.5;  // m

// A hole in a wall, by its distance along the wall and its height.
struct Hole {
  double left = 0.0, right = 0.0, low = 0.0, high = 0.0;
};

// From its foot's left end (seen from inside the room) along its length and up. Cut so that holes have
// corners.
Mesh wall(const Vec3d& foot, const Vec3d& along, double height, Paint paint, const Hole& hole = {}) {
  const auto length = glm::length(along);
  auto a = std::vector<double>{0.0, length};
  auto b = std::vector<double>{0.0, height};
  if (hole.right > hole.left) a = {0.0, hole.left, hole.right, length};
  if (hole.right > hole.left)
    b = hole.low > 0.0 ? std::vector<double>{0.0, hole.low, hole.high, height}
                       : std::vector<double>{0.0, hole.high, height};
  auto in_hole = [&](double s, double t) {
    return s > hole.left && s < hole.right && t > hole.low && t < hole.high;
  };
  return painted(
      panel(foot, along / length, {0.0, 1.0, 0.0}, steps(a, wall_cell), steps(b, wall_cell), in_hole), paint);
}

Mesh ceiling(const Vec3d& low, const Vec3d& high, Paint paint) {
  return painted(panel({low.x, high.y, low.z}, {1.0, 0.0, 0.0}, {0.0, 0.0, 1.0},
                       steps({0.0, high.x - low.x}, wall_cell), steps({0.0, high.z - low.z}, wall_cell)),
                 paint);
}

Mesh floor(const Vec3d& low, const Vec3d& high, double plank_length, double plank_width) {
  return panel({low.x, low.y, high.z}, {1.0, 0.0, 0.0}, {0.0, 0.0, -1.0},
               steps({0.0, high.x - low.x}, plank_length), steps({0.0, high.z - low.z}, plank_width));
}

// Planks of one to four cells, each in one of four oaks.
Mesh planked(Mesh mesh, double cell_length, double plank_width) {
  constexpr std::array oaks = {Paint::floor_oak_1, Paint::floor_oak_2, Paint::floor_oak_3,
                               Paint::floor_oak_4};
  for (auto& triangle : mesh.triangles) {
    const auto p = centroid(mesh, triangle) - room_low;
    const auto row = static_cast<std::uint64_t>(p.z / plank_width);
    const auto shift = static_cast<std::uint64_t>(4.0 * dice(41, row));
    const auto plank = (static_cast<std::uint64_t>(p.x / cell_length) + shift) / 4;
    triangle.paint = oaks[static_cast<std::size_t>(4.0 * dice(42, row, plank))];
  }
  return mesh;
}

void add_reading_room(std::vector<Object>& objects) {
  const auto x = Vec3d(room_high.x - room_low.x, 0.0, 0.0);
  const auto z = Vec3d(0.0, 0.0, room_high.z - room_low.z);
  const auto height = room_high.y - room_low.y;
  const auto door_hole = Hole{.left = room_high.z - door_middle.z - 0.5 * door.width,
                              .right = room_high.z - door_middle.z + 0.5 * door.width,
                              .high = door.height};
  const auto window_hole = Hole{.left = window_middle.x - room_low.x - 0.5 * window.width,
                                .right = window_middle.x - room_low.x + 0.5 * window.width,
                                .low = window_middle.y - 0.5 * window.height,
                                .high = window_middle.y + 0.5 * window.height};
  const auto front_left = Vec3d(room_low.x, 0.0, room_high.z);
  const auto front_right = Vec3d(room_high.x, 0.0, room_high.z);
  const auto back_right = Vec3d(room_high.x, 0.0, room_low.z);
  objects.push_back({"floor", planked(floor(room_low, room_high, 0.50, 0.20), 0.50, 0.20), false});
  objects.push_back({"ceiling", ceiling(room_low, room_high, Paint::ceiling_white), false});
  objects.push_back({"wall_left", wall(front_left, -z, height, Paint::terracotta_wall, door_hole), false});
  objects.push_back({"wall_back", wall(room_low, x, height, Paint::cream_wall, window_hole), false});
  objects.push_back({"wall_right", wall(back_right, z, height, Paint::sage_wall), false});
  objects.push_back({"wall_front", wall(front_right, -x, height, Paint::cream_wall), false});
}

void add_corridor(std::vector<Object>& objects) {
  const auto x = Vec3d(corridor_high.x - corridor_low.x, 0.0, 0.0);
  const auto z = Vec3d(0.0, 0.0, corridor_high.z - corridor_low.z);
  const auto height = corridor_high.y - corridor_low.y;
  const auto hole = Hole{.left = door_middle.z - corridor_low.z - 0.5 * door.width,
                         .right = door_middle.z - corridor_low.z + 0.5 * door.width,
                         .high = door.height};
  const auto paint = Paint::corridor_yellow;
  const auto walls =
      joined({wall(corridor_low + z, -z, height, paint), wall(corridor_low, x, height, paint),
              wall(corridor_low + x, z, height, paint, hole), wall(corridor_low + x + z, -x, height, paint)});
  objects.push_back({"corridor_walls", walls, false});
  objects.push_back({"corridor_ceiling", ceiling(corridor_low, corridor_high, Paint::ceiling_white), false});
  objects.push_back({"corridor_floor",
                     painted(floor(corridor_low, corridor_high, 0.4, 0.4), Paint::corridor_floor), false});
}

// A skirting board that starts at the given place and runs along +z, turned about it; its back to -x.
Mesh skirting(double length, const Vec3d& at, double turn) {
  return placed(prism({{0.0, 0.0}, {0.016, 0.0}, {0.016, 0.078}, {0.008, 0.088}, {0.0, 0.088}}, length), at,
                turn);
}

Mesh skirtings() {
  constexpr auto thick = 0.018;  // the board and its joint: boards end here at the corners
  constexpr auto casing = 0.085;
  const auto low = room_low + joint;
  const auto high = room_high - joint;
  const auto across = high.x - low.x - 2.0 * thick;
  const auto door_back = door_middle.z - 0.5 * door.width - casing;
  const auto door_front = door_middle.z + 0.5 * door.width + casing;
  return painted(
      joined({skirting(high.z - door_front, {low.x, low.y, door_front}, 0.0),
              skirting(door_back - low.z, low, 0.0), skirting(across, {high.x - thick, low.y, low.z}, -90.0),
              skirting(high.z - low.z, {high.x, low.y, high.z}, 180.0),
              skirting(across, {low.x + thick, low.y, high.z}, 90.0)}),
      Paint::painted_wood);
}

Mesh beams() {
  auto mesh = Mesh{};
  const auto beam = box({0.14, 0.15, room_high.z - room_low.z - 2.0 * joint});
  for (const auto x : {-2.1, -0.7, 0.7, 2.1}) {
    append(mesh, placed(beam, {x, room_high.y - 0.15 - joint, 0.0}));
  }
  return painted(mesh, Paint::oak);
}

// Boards round the doorway, on the room's side.
Mesh door_casing() {
  constexpr auto board = 0.08;
  const auto x = room_low.x + joint + 0.010;
  const auto side = 0.5 * (door.width + board) + joint;
  const auto post = box({0.020, door.height, board});
  const auto lintel = box({0.022, board, door.width + 2.0 * board + 0.02});
  return painted(
      joined({placed(post, {x, joint, door_middle.z - side}), placed(post, {x, joint, door_middle.z + side}),
              placed(lintel, {x + 0.001, door.height + 2.0 * joint, door_middle.z})}),
      Paint::painted_wood);
}

}  // namespace

std::vector<Object> shell() {
  auto objects = std::vector<Object>{};
  add_reading_room(objects);
  add_corridor(objects);
  const auto threshold = [](const Vec3d&, const Vec3d& normal) { return normal.y > 0.9; };
  objects.push_back(
      {"doorway", painted(placed(reveal(door), door_middle, 90.0), Paint::oak, threshold), false});
  objects.push_back({"window_reveal", placed(reveal(window), window_middle), false});
  const auto outside = window_middle - Vec3d(0.0, 0.0, window.depth);
  const auto [w, h, d] = window;
  objects.push_back({"window_sky", placed(evening_sky(w, h), outside), false});
  objects.push_back({"window_town", placed(town(w, h), outside), false});
  objects.push_back({"window_town_lights", placed(lit_windows(w, h), outside), false});
  return objects;
}

std::vector<Object> woodwork() {
  return {{"skirting_boards", skirtings()},
          {"beams", beams()},
          {"door_casing", door_casing()},
          {"window_frame", placed(window_frame(window), window_middle)}};
}

}  // namespace luxel::scenes
