// SPDX-License-Identifier: Apache-2.0
// A chapel of three aisles, with the sun through its windows.

#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "scenes/furniture/church.h"
#include "scenes/places/places.h"
#include "scenes/shapes/dice.h"
#include "scenes/shapes/sheets.h"
#include "scenes/shapes/solids.h"
#include "scenes/shapes/sweeping.h"
#include "scenes/shapes/walls.h"

namespace luxel::scenes {
namespace {

constexpr auto on_floor = 0.001;
constexpr auto nave = 2.9;     // m, half of its width
constexpr auto arcade = 0.60;  // m, thickness of the nave's walls
constexpr auto aisle = 5.9;    // m, from the axis to the outer wall
constexpr auto back = -9.5, front = 7.3;
constexpr auto bay = 2.8;  // m
constexpr auto bays = 6;
constexpr auto springing = 2.9;  // m, of the arcade's arches
constexpr auto aisle_height = 4.7;
constexpr auto wall_top = 7.4;  // m, where the vault begins
constexpr auto vault_rise = 2.3;
constexpr auto thick = 0.7;  // m, of the outer walls

// The bays' windows, in a wall whose left end is at one end of the nave.
std::vector<Hole> windows(double width, double low, double high, double rise) {
  auto holes = std::vector<Hole>{};
  for (auto k = 0; k < bays; ++k) {
    const auto middle = bay * (k + 0.5);
    holes.push_back({.left = middle - 0.5 * width,
                     .right = middle + 0.5 * width,
                     .low = low,
                     .high = high,
                     .rise = rise});
  }
  return holes;
}

// The outer walls with the aisles' windows, and a large one above the altar.
Room shell_of_chapel() {
  auto room = Room{.low = {-aisle, 0.0, back}, .high = {aisle, aisle_height, front}, .thickness = thick};
  room.holes[left_wall] = windows(1.1, 1.5, 3.1, 0.55);
  room.holes[right_wall] = windows(1.1, 1.5, 3.1, 0.55);
  return room;
}

// The whole end wall of the nave up to the vault.
Face end_face(bool at_back) {
  return at_back ? Face{{-nave, 0.0, back}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 2.0 * nave, wall_top}
                 : Face{{nave, 0.0, front}, {-1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 2.0 * nave, wall_top};
}

std::vector<Hole> altar_window() {
  return {{.left = nave - 0.95, .right = nave + 0.95, .low = 3.3, .high = 5.7, .rise = 0.95}};
}

constexpr auto vault_pieces = 24;

Vec3d on_vault(double t, double z) {
  const auto angle = std::numbers::pi * t;
  return {nave * std::cos(angle), wall_top + vault_rise * std::sin(angle), z};
}

Mesh vault() {
  return sheet(vault_pieces, 3 * bays,
               [](double s, double t) { return on_vault(1.0 - s, glm::mix(back, front, t)); });
}

Mesh tympanum(double z, bool faces_front) {
  auto mesh = Mesh{};
  const auto middle = mesh.add_point({0.0, wall_top, z});
  for (auto k = 0; k <= vault_pieces; ++k) mesh.add_point(on_vault(static_cast<double>(k) / vault_pieces, z));
  for (auto k = 1u; k <= vault_pieces; ++k) {
    faces_front ? mesh.add_triangle(middle, k, k + 1) : mesh.add_triangle(middle, k + 1, k);
  }
  return mesh;
}

void add_floor(MadeScene& scene, const Room& room) {
  auto floor = room_floor(room, 0.7, 0.7);
  for (auto& triangle : floor.triangles) {
    const auto p = centroid(floor, triangle) - room.low;
    const auto i = static_cast<int>(p.x / 0.7), j = static_cast<int>(p.z / 0.7);
    const auto in_nave = std::abs(p.x - aisle) < nave;
    const auto tile = static_cast<std::uint64_t>(1000 * i + j);
    triangle.paint = in_nave && (i + j) % 2 == 0
                         ? Paint::stone_grey
                         : (dice(150, tile) < 0.5 ? Paint::stone_warm : Paint::paving_3);
  }
  scene.add_open("floor", floor);
}

void add_outer_walls(MadeScene& scene, const Room& room) {
  scene.add_open("wall_left", painted(inner_wall(room, left_wall, 0.7), Paint::plaster_white));
  scene.add_open("wall_right", painted(inner_wall(room, right_wall, 0.7), Paint::plaster_white));
  scene.add_open("window_reveals", painted(all_reveals(room), Paint::stone_pale));
  // End walls: those of the aisles beside those of the nave.
  auto ends = Mesh{};
  const auto up = steps({0.0, aisle_height}, 0.7);
  for (const auto side : {-1.0, 1.0}) {
    const auto left = side < 0.0 ? -aisle : nave;
    append(ends,
           panel({left, 0.0, back}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, steps({0.0, aisle - nave}, 0.7), up));
    append(ends, panel({left + aisle - nave, 0.0, front}, {-1.0, 0.0, 0.0}, {0.0, 1.0, 0.0},
                       steps({0.0, aisle - nave}, 0.7), up));
  }
  append(ends, holed_face(end_face(true), altar_window(), 0.7));
  append(ends, tympanum(back, true));
  append(ends, holed_face(end_face(false), {}, 0.7));
  append(ends, tympanum(front, false));
  scene.add_open("end_walls", painted(ends, Paint::plaster_white));
  scene.add_open("altar_window_reveal",
                 painted(reveals(end_face(true), altar_window(), thick), Paint::stone_pale));
  scene.add_open("vault", painted(vault(), Paint::cream_wall));
}

// The nave's walls: columns, arches and the upper windows; between their outer faces and the outer walls the
// aisles' ceilings.
void add_nave_walls(MadeScene& scene) {
  auto walls = Mesh{};
  auto soffits = Mesh{};
  auto columns = Mesh{};
  const auto length = front - back;
  for (const auto side : {-1.0, 1.0}) {
    const auto face =
        side < 0.0
            ? Face{{-nave, springing, front}, {0.0, 0.0, -1.0}, {0.0, 1.0, 0.0}, length, wall_top - springing}
            : Face{{nave, springing, back}, {0.0, 0.0, 1.0}, {0.0, 1.0, 0.0}, length, wall_top - springing};
    auto holes = windows(bay - 0.62, 0.0, 0.0, 1.25);
    const auto upper = windows(1.25, 5.2 - springing, 6.45 - springing, 0.6);
    holes.insert(holes.end(), upper.begin(), upper.end());
    append(walls, holed_wall(face, holes, arcade, 0.7));
    // What stands on the columns: the undersides between the arches.
    for (auto k = 0; k <= bays; ++k) {
      const auto low = k == 0 ? 0.0 : bay * k - 0.31;
      const auto high = k == bays ? length : bay * k + 0.31;
      append(soffits, panel({side < 0.0 ? -nave - arcade : nave, springing, back + low}, {1.0, 0.0, 0.0},
                            {0.0, 0.0, 1.0}, {0.0, arcade}, {0.0, high - low}));
      const auto z = back + std::clamp(bay * k, 0.32, length - 0.32);
      append(columns, moved(column(0.20, springing - 0.002, Paint::stone_pale),
                            {side * (nave + 0.5 * arcade), on_floor, z}));
    }
  }
  scene.add_open("nave_walls", painted(walls, Paint::plaster_white));
  scene.add_open("nave_wall_undersides", painted(soffits, Paint::stone_pale));
  scene.add_closed("columns", columns);
  auto ceilings = Mesh{};
  for (const auto side : {-1.0, 1.0}) {
    const auto left = side < 0.0 ? -aisle : nave + arcade;
    append(ceilings, panel({left, aisle_height, back}, {1.0, 0.0, 0.0}, {0.0, 0.0, 1.0},
                           steps({0.0, aisle - nave - arcade}, 0.6), steps({0.0, length}, 0.7)));
  }
  scene.add_open("aisle_ceilings", painted(ceilings, Paint::oak));
  // Arches across the vault, on the axes of the columns.
  auto ribs = Mesh{};
  for (auto k = 1; k < bays; ++k) {
    auto path = std::vector<Vec3d>{};
    for (auto i = 0; i <= 24; ++i) {
      const auto p = on_vault(i / 24.0, back + bay * k);
      path.emplace_back(0.975 * p.x, wall_top + 0.975 * (p.y - wall_top) - 0.02, p.z);
    }
    append(ribs, tube(path, 0.075, 8));
  }
  scene.add_closed("ribs", painted(ribs, Paint::stone_pale));
}

void add_outside(MadeScene& scene) {
  auto stone = Mesh{};
  auto roofs = Mesh{};
  const auto length = front - back + 2.0 * thick;
  const auto z = 0.5 * (front + back);
  const auto outer = shell_of_chapel();
  for (const auto wall : {left_wall, right_wall}) {
    const auto face = inner_face(outer, wall);
    const auto normal = glm::cross(face.along, face.up);
    auto holes = std::vector<Hole>{};
    for (auto hole : outer.holes[wall]) {
      std::swap(hole.left, hole.right);
      hole.left = face.length - hole.left;
      hole.right = face.length - hole.right;
      holes.push_back(hole);
    }
    append(stone, holed_face({face.origin - thick * normal + face.length * face.along, -face.along, face.up,
                              face.length, face.height},
                             holes, 1.0));
  }
  scene.add_open("outside", painted(stone, Paint::stone_warm));
  // Lean-to roofs over the aisles and a saddle roof over the nave, each a closed body.
  for (const auto side : {-1.0, 1.0}) {
    const auto outline = std::vector<glm::dvec2>{{nave + arcade + 0.002, aisle_height + 0.02},
                                                 {aisle + thick + 0.25, aisle_height + 0.02},
                                                 {aisle + thick + 0.25, aisle_height + 0.12},
                                                 {nave + arcade + 0.002, aisle_height + 0.42}};
    auto mirrored = outline;
    for (auto& p : mirrored) p.x = -p.x;
    std::reverse(mirrored.begin(), mirrored.end());
    append(roofs, moved(prism(side > 0.0 ? outline : mirrored, length), {0.0, 0.0, z - 0.5 * length}));
  }
  append(roofs, moved(prism({{-nave - arcade - 0.3, wall_top + vault_rise + 0.1},
                             {nave + arcade + 0.3, wall_top + vault_rise + 0.1},
                             {0.0, wall_top + vault_rise + 2.2}},
                            length),
                      {0.0, 0.0, z - 0.5 * length}));
  scene.add_closed("roofs", painted(roofs, Paint::slate));
  scene.add_open("churchyard", painted(panel({-26.0, -0.4, 22.0}, {1.0, 0.0, 0.0}, {0.0, 0.0, -1.0},
                                             steps({0.0, 52.0}, 4.0), steps({0.0, 44.0}, 4.0)),
                                       Paint::grass));
}

void add_furnishings(MadeScene& scene) {
  const auto dais = [&](double y, double size, double z) {
    return moved(rounded_box({size, 0.16, 3.4 - (5.4 - size)}, 0.015), {0.0, y, z});
  };
  scene.add_closed(
      "dais", painted(joined({dais(on_floor, 5.0, back + 1.66), dais(on_floor + 0.161, 4.4, back + 1.40)}),
                      Paint::stone_pale));
  const auto top = on_floor + 0.322;
  const auto at = Vec3d(0.0, top, back + 1.35);
  scene.add_closed("altar", placed(altar(), at));
  for (const auto side : {-1.0, 1.0}) {
    for (auto k = 0; k < 2; ++k) {
      const auto foot = at + Vec3d(side * (0.52 + 0.26 * k), 1.031, -0.12);
      const auto height = 0.62 - 0.14 * k;
      const auto name = std::string(side < 0.0 ? "left_" : "right_") + std::to_string(k + 1);
      scene.add_closed("candlestick_" + name, placed(candlestick(height), foot));
      scene.add_closed("flame_" + name,
                       placed(candle_flame(), foot + Vec3d(0.0, 0.98 * height + 0.004, 0.0)));
    }
  }
  scene.add_closed("cross", placed(cross(1.5), {0.0, 1.72, back + 0.075}));
  for (auto row = 0; row < 7; ++row) {
    const auto z = back + 5.3 + 1.12 * row;
    for (const auto side : {-1.0, 1.0}) {
      scene.add_closed((side < 0.0 ? "pew_left_" : "pew_right_") + std::to_string(row + 1),
                       placed(pew(1.95), {side * 1.62, on_floor, z}));
    }
  }
  scene.add_closed("font", placed(font(), {-1.75, on_floor, back + 3.9}));
}

}  // namespace

MadeScene chapel() {
  auto scene =
      MadeScene{.title = "A chapel of three aisles, with the sun through its windows", .sky = "7,10,16"};
  const auto room = shell_of_chapel();
  add_floor(scene, room);
  add_outer_walls(scene, room);
  add_nave_walls(scene);
  add_outside(scene);
  add_furnishings(scene);
  scene.lights = {{PunctualLight::sun, "sun", {}, {-0.62, -0.76, -0.22}, 80'000.0, {1.0, 0.88, 0.70}}};
  scene.views = {{"down the nave", {0.9, 1.65, 6.6}, {-0.25, 2.75, -9.0}, 55.0},
                 {"an aisle", {-4.75, 1.6, 6.3}, {-3.6, 1.6, -6.0}, 55.0}};
  return scene;
}

}  // namespace luxel::scenes
