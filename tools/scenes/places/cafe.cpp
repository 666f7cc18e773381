// SPDX-License-Identifier: Apache-2.0
// A cafe in the evening: pendant lamps over the tables, a bar with lit shelves.

#include <string>
#include <utility>

#include "scenes/furniture/dining.h"
#include "scenes/furniture/lamps.h"
#include "scenes/furniture/pictures.h"
#include "scenes/furniture/plant.h"
#include "scenes/furniture/tables.h"
#include "scenes/places/places.h"
#include "scenes/places/skyline.h"
#include "scenes/shapes/dice.h"
#include "scenes/shapes/sheets.h"
#include "scenes/shapes/solids.h"
#include "scenes/shapes/sweeping.h"
#include "scenes/shapes/turning.h"
#include "scenes/shapes/walls.h"

namespace luxel::scenes {
namespace {

constexpr auto on_floor = 0.001;
constexpr auto dado = 1.30;  // m, of tiles
constexpr auto window_width = 1.9, window_low = 0.75, window_high = 2.55;
constexpr double window_lefts[] = {0.7, 3.2, 5.7};  // from the left wall's front corner

Room shell_of_cafe() {
  auto room = Room{.low = {-3.2, 0.0, -4.2}, .high = {3.2, 3.1, 4.2}, .thickness = 0.32};
  for (const auto left : window_lefts)
    room.holes[left_wall].push_back(
        {.left = left, .right = left + window_width, .low = window_low, .high = window_high});
  return room;
}

void add_shell(MadeScene& scene, const Room& room) {
  auto floor = room_floor(room, 0.4, 0.4);
  for (auto& triangle : floor.triangles) {
    const auto p = centroid(floor, triangle) - room.low;
    triangle.paint = (static_cast<int>(p.x / 0.4) + static_cast<int>(p.z / 0.4)) % 2 == 0 ? Paint::terrazzo_1
                                                                                          : Paint::terrazzo_2;
  }
  scene.add_open("floor", floor);
  scene.add_open("ceiling", painted(inner_wall(room, ceiling_side), Paint::cream_wall));
  for (const auto& [name, wall] : {std::pair("wall_back", back_wall), std::pair("wall_right", right_wall),
                                   std::pair("wall_front", front_wall), std::pair("wall_left", left_wall)}) {
    scene.add_open(name, painted(inner_wall(room, wall),
                                 wall == right_wall ? Paint::terracotta_wall : Paint::cream_wall));
  }
  scene.add_open("reveals", painted(all_reveals(room), Paint::tile_green));
  // Tiles below, with a rail above them; on the three walls without windows.
  auto tiles = Mesh{};
  auto rails = Mesh{};
  for (const auto wall : {back_wall, right_wall, front_wall}) {
    const auto face = inner_face(room, wall);
    const auto normal = glm::cross(face.along, face.up);
    for (auto row = 0; row < 6; ++row) {
      for (auto x = 0.04; x < face.length - 0.30; x += 0.29) {
        const auto tile = chamfered_box({0.284, 0.205, 0.02}, 0.006);
        const auto middle =
            face.origin + (x + 0.145) * face.along + (0.06 + 0.208 * row) * face.up + 0.012 * normal;
        append(tiles, placed(tile, middle, wall == back_wall ? 0.0 : wall == right_wall ? -90.0 : 180.0));
      }
    }
    append(rails,
           placed(rounded_box({face.length - 0.14, 0.05, 0.045}, 0.012),
                  face.origin + 0.5 * face.length * face.along + (dado + 0.02) * face.up + 0.025 * normal,
                  wall == back_wall    ? 0.0
                  : wall == right_wall ? -90.0
                                       : 180.0));
  }
  scene.add_closed("tiles", painted(tiles, Paint::tile_green));
  scene.add_closed("rails", painted(rails, Paint::walnut));
  // The evening sky outside, close behind each window.
  for (auto k = 0; k < 3; ++k) {
    const auto z = room.high.z - window_lefts[k] - 0.5 * window_width;
    const auto middle = Vec3d(room.low.x - room.thickness, 0.5 * (window_low + window_high), z);
    const auto name = std::to_string(k + 1);
    scene.add_open("window_sky_" + name,
                   placed(evening_sky(window_width, window_high - window_low), middle, 90.0));
    scene.add_open("window_town_" + name, placed(town(window_width, window_high - window_low), middle, 90.0));
    scene.add_open("window_lights_" + name,
                   placed(lit_windows(window_width, window_high - window_low), middle, 90.0));
    auto bars = frame(window_width - 0.104, window_high - window_low - 0.104,
                      {{0.0, 0.0}, {0.05, 0.0}, {0.05, 0.05}, {0.0, 0.05}});
    for (const auto x : {-0.31, 0.31})
      append(bars, placed(box({0.035, window_high - window_low - 0.106, 0.04}),
                          {x, -0.5 * (window_high - window_low) + 0.053, 0.005}));
    append(bars, placed(rounded_box({window_width + 0.08, 0.03, 0.18}, 0.01),
                        {0.0, -0.5 * (window_high - window_low) - 0.033, 0.252}));
    scene.add_closed("window_frame_" + name,
                     placed(painted(bars, Paint::walnut), middle + Vec3d(0.16, 0.0, 0.0), 90.0));
  }
}

Mesh bottle(std::uint64_t which) {
  constexpr Paint glass[] = {Paint::bottle_green, Paint::bottle_amber, Paint::glaze_cobalt, Paint::book_red,
                             Paint::porcelain};
  const auto tall = dice_between(0.24, 0.33, 180, which);
  const auto wide = dice_between(0.032, 0.044, 181, which);
  return painted(lathe({{0.0, 0.0},
                        {wide, 0.0},
                        {wide, 0.55 * tall},
                        {0.8 * wide, 0.65 * tall},
                        {0.013, 0.74 * tall},
                        {0.012, 0.94 * tall},
                        {0.015, 0.95 * tall},
                        {0.015, tall},
                        {0.0, tall}},
                       14),
                 glass[static_cast<std::size_t>(5.0 * dice(182, which))]);
}

// Along the right wall: a counter, shelves behind it, each lit by a strip below the next.
void add_bar(MadeScene& scene, const Room& room) {
  const auto at = Vec3d(room.high.x, on_floor, -1.2);
  auto counter = painted(placed(rounded_box({4.2, 1.02, 0.55}, 0.015), {0.0, 0.02, 1.30}), Paint::walnut);
  for (auto k = 0; k < 7; ++k)
    append(counter, painted(placed(rounded_box({0.54, 0.84, 0.03}, 0.012), {-1.8 + 0.6 * k, 0.11, 1.592}),
                            Paint::tile_green));
  append(counter, painted(placed(rounded_box({4.36, 0.05, 0.72}, 0.018), {0.0, 1.042, 1.32}), Paint::marble));
  append(counter,
         painted(placed(turned_z(moved(cylinder(0.022, 4.0, 12), {0.0, -2.0, 0.0}), 90.0), {0.0, 0.20, 1.70}),
                 Paint::brass));
  scene.add_closed("counter", placed(counter, at, -90.0));
  auto shelves = painted(placed(rounded_box({4.2, 0.86, 0.40}, 0.012), {0.0, 0.02, 0.26}), Paint::walnut);
  auto strips = Mesh{};
  auto bottles = Mesh{};
  for (auto row = 0; row < 3; ++row) {
    const auto y = 1.40 + 0.45 * row;
    append(shelves, painted(placed(rounded_box({4.0, 0.035, 0.26}, 0.008), {0.0, y, 0.18}), Paint::walnut));
    append(strips, placed(turned_x(panel({-1.9, 0.0, -0.012}, {1.0, 0.0, 0.0}, {0.0, 0.0, 1.0},
                                         steps({0.0, 3.8}, 0.4), {0.0, 0.018}),
                                   0.0),
                          {0.0, y - 0.002, 0.27}));
    for (auto k = 0; k < 26; ++k) {
      const auto which = static_cast<std::uint64_t>(100 * row + k);
      if (dice(183, which) < 0.12) continue;
      append(bottles, moved(bottle(which), {-1.88 + 0.15 * k + dice_between(-0.02, 0.02, 184, which),
                                            y + 0.037, 0.17 + dice_between(-0.03, 0.03, 185, which)}));
    }
  }
  scene.add_closed("shelves", placed(shelves, at, -90.0));
  scene.add_open("shelf_strips", placed(painted(strips, Paint::lamp_cafe_counter), at, -90.0));
  scene.add_closed("bottles", placed(bottles, at, -90.0));
  // On the counter: a machine, cups, a cake stand.
  const auto machine =
      joined({painted(rounded_box({0.75, 0.10, 0.46}, 0.02), Paint::black_steel),
              painted(moved(rounded_box({0.75, 0.20, 0.30}, 0.04), {0.0, 0.28, -0.06}), Paint::brass),
              painted(moved(rounded_box({0.70, 0.178, 0.12}, 0.01), {0.0, 0.101, -0.15}), Paint::black_steel),
              painted(moved(cylinder(0.03, 0.08, 12), {-0.18, 0.199, 0.02}), Paint::black_steel),
              painted(moved(cylinder(0.03, 0.08, 12), {0.18, 0.199, 0.02}), Paint::black_steel)});
  scene.add_closed("machine", placed(placed(machine, {-1.2, 1.093, 1.28}, 180.0), at, -90.0));
  auto cups = Mesh{};
  for (auto k = 0; k < 6; ++k)
    append(cups, moved(mug(Paint::porcelain), {-0.50 + 0.10 * (k % 3), 1.093, 1.22 + 0.10 * (k / 3)}));
  append(cups, moved(painted(lathe({{0.0, 0.0},
                                    {0.08, 0.0},
                                    {0.08, 0.01},
                                    {0.02, 0.02},
                                    {0.02, 0.12},
                                    {0.16, 0.13},
                                    {0.16, 0.14},
                                    {0.0, 0.14}},
                                   28),
                             Paint::porcelain),
                     {0.6, 1.093, 1.30}));
  append(cups, moved(painted(lathe({{0.0, 0.0}, {0.12, 0.0}, {0.125, 0.05}, {0.11, 0.08}, {0.0, 0.085}}, 28),
                             Paint::rug_rust),
                     {0.6, 1.235, 1.30}));
  scene.add_closed("counter_things", placed(cups, at, -90.0));
}

Mesh cafe_table() {
  return joined({painted(moved(lathe({{0.0, 0.0},
                                      {0.36, 0.0},
                                      {0.375, 0.008},
                                      {0.375, 0.018},
                                      {0.36, 0.026},
                                      {0.2, 0.026},
                                      {0.0, 0.026}},
                                     32),
                               {0.0, 0.724, 0.0}),
                         Paint::marble),
                 painted(lathe({{0.0, 0.0},
                                {0.24, 0.0},
                                {0.24, 0.015},
                                {0.05, 0.045},
                                {0.03, 0.08},
                                {0.03, 0.66},
                                {0.06, 0.715},
                                {0.0, 0.723}},
                               24),
                         Paint::black_steel)});
}

void add_tables(MadeScene& scene, const Room& room) {
  auto k = 0;
  const auto add_lamp_at = [&](const std::string& name, const Vec3d& at) {
    const auto lamp = pendant_lamp();
    scene.add_closed(name + "_stand", moved(lamp.stand, at));
    scene.add_closed(name + "_bulb", moved(painted(lamp.bulb, Paint::lamp_cafe_bulb), at));
  };
  for (const auto& at : {Vec3d(-2.3, on_floor, -2.9), Vec3d(-2.3, on_floor, -0.5), Vec3d(-2.3, on_floor, 1.9),
                         Vec3d(-0.5, on_floor, -1.8), Vec3d(-0.4, on_floor, 0.75)}) {
    const auto of = static_cast<std::uint64_t>(++k);
    const auto name = std::to_string(k);
    scene.add_closed("table_" + name, moved(cafe_table(), at));
    const auto turn = dice_between(-25.0, 25.0, 190, of) + (k > 3 ? 45.0 : 0.0);
    for (auto c = 0; c < 2; ++c) {
      const auto seat = (k + c) % 3 == 0 ? Paint::ochre_cloth : Paint::walnut;
      scene.add_closed("chair_" + name + (c == 0 ? "a" : "b"),
                       placed(moved(chair(seat), {0.0, 0.0, -0.56}), at, turn + 180.0 * c));
    }
    const auto top = at + Vec3d(0.0, 0.751, 0.0);
    scene.add_closed("cups_" + name,
                     placed(joined({moved(mug(Paint::porcelain), {0.12, 0.0, 0.10}),
                                    moved(mug(Paint::glaze_turquoise), {-0.14, 0.0, -0.11}),
                                    moved(vase(Paint::glaze_cobalt, 0.16), {0.02, 0.0, -0.02})}),
                            top, turn));
    add_lamp_at("pendant_" + name, {at.x, room.high.y - 0.001, at.z});
  }
  for (auto i = 0; i < 3; ++i)
    add_lamp_at("bar_pendant_" + std::to_string(i + 1),
                {room.high.x - 1.32, room.high.y - 0.001, -2.6 + 1.4 * i});
  for (auto i = 0; i < 4; ++i) {
    const auto stool = joined(
        {painted(
             moved(lathe({{0.0, 0.0}, {0.17, 0.0}, {0.185, 0.02}, {0.18, 0.055}, {0.10, 0.07}, {0.0, 0.072}},
                         24),
                   {0.0, 0.70, 0.0}),
             Paint::coral_cloth),
         painted(lathe({{0.0, 0.0},
                        {0.21, 0.0},
                        {0.21, 0.012},
                        {0.03, 0.035},
                        {0.022, 0.08},
                        {0.022, 0.698},
                        {0.0, 0.698}},
                       20),
                 Paint::brass)});
    scene.add_closed("stool_" + std::to_string(i + 1),
                     moved(stool, {room.high.x - 2.02, on_floor, -2.75 + 1.0 * i}));
  }
}

void add_walls_things(MadeScene& scene, const Room& room) {
  constexpr Motif motifs[] = {Motif::sunset, Motif::moon, Motif::rainbow};
  for (auto k = 0; k < 3; ++k) {
    const auto at = Vec3d(-2.0 + 1.15 * k, 2.05, room.low.z);
    scene.add_closed("picture_frame_" + std::to_string(k + 1),
                     placed(picture_frame(0.6, 0.8, Paint::walnut), at));
    scene.add_open("picture_sheet_" + std::to_string(k + 1), placed(picture_sheet(0.6, 0.8, motifs[k]), at));
  }
  const auto pot = Vec3d(-2.75, on_floor, 3.55);
  scene.add_closed("plant_pot", placed(plant_pot(), {1.1, on_floor, -3.75}));
  scene.add_closed("plant_stems", placed(plant_stems(), {1.1, on_floor, -3.75}));
  scene.add_open("plant_leaves", placed(plant_leaves(), {1.1, on_floor, -3.75}));
  scene.add_closed("vase", placed(bellied_vase(Paint::glaze_turquoise, 0.6), pot));
}

}  // namespace

MadeScene cafe() {
  auto scene = MadeScene{.title = "A cafe in the evening, with pendant lamps and a bar"};
  const auto room = shell_of_cafe();
  add_shell(scene, room);
  add_bar(scene, room);
  add_tables(scene, room);
  add_walls_things(scene, room);
  scene.views = {{"the whole cafe", {1.55, 1.58, 3.95}, {-0.55, 1.15, -1.9}, 56.0},
                 {"the bar", {-2.6, 1.55, 1.6}, {2.6, 1.2, -1.6}, 48.0}};
  return scene;
}

}  // namespace luxel::scenes
