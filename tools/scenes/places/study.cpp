// SPDX-License-Identifier: Apache-2.0
// A small room for glTF: a desk under a window, a lamp that is a surface, a spot that is none, and the sun.

#include "scenes/furniture/seating.h"
#include "scenes/furniture/tables.h"
#include "scenes/places/places.h"
#include "scenes/shapes/sheets.h"
#include "scenes/shapes/solids.h"
#include "scenes/shapes/sweeping.h"
#include "scenes/shapes/turning.h"
#include "scenes/shapes/walls.h"

namespace luxel::scenes {
namespace {

constexpr auto on_floor = 0.001;

Room shell_of_study() {
  auto room = Room{.low = {-1.7, 0.0, -1.5}, .high = {1.7, 2.5, 1.5}, .thickness = 0.28};
  room.holes[back_wall] = {{.left = 0.55, .right = 1.85, .low = 0.95, .high = 1.85, .rise = 0.35}};
  return room;
}

}  // namespace

MadeScene study() {
  auto scene =
      MadeScene{.title = "A study with the sun at its window, a desk lamp and a spot", .sky = "6,9,14"};
  const auto room = shell_of_study();
  scene.add_open("floor", painted(room_floor(room, 1.0, 1.0), Paint::floor_oak_2));
  scene.add_open("ceiling", painted(inner_wall(room, ceiling_side, 1.2), Paint::plaster_white));
  scene.add_open("wall_back", painted(inner_wall(room, back_wall, 1.0), Paint::cream_wall));
  scene.add_open("wall_right", painted(inner_wall(room, right_wall, 1.2), Paint::plaster_blue));
  scene.add_open("wall_front", painted(inner_wall(room, front_wall, 1.2), Paint::cream_wall));
  scene.add_open("wall_left", painted(inner_wall(room, left_wall, 1.2), Paint::terracotta_wall));
  scene.add_open("window_reveal", painted(all_reveals(room), Paint::plaster_white));
  scene.add_closed("skirting_boards", painted(skirting_boards(room), Paint::painted_wood));
  scene.add_closed("window_sill", painted(moved(box({1.40, 0.03, 0.20}), {-0.5, 0.918, room.low.z + 0.102}),
                                          Paint::painted_wood));
  const auto desk = Vec3d(-0.5, on_floor, -0.92);
  auto wood = moved(box({1.40, 0.035, 0.65}), {0.0, 0.705, 0.0});
  for (const auto x : {-0.64, 0.64}) {
    for (const auto z : {-0.27, 0.27}) append(wood, moved(box({0.05, 0.704, 0.05}), {x, 0.0, z}));
  }
  scene.add_closed("desk", moved(painted(wood, Paint::oak), desk));
  const auto top = desk + Vec3d(0.0, 0.741, 0.0);
  scene.add_closed("book_1", placed(painted(box({0.22, 0.035, 0.30}), Paint::book_red),
                                    top + Vec3d(-0.40, 0.0, 0.05), 12.0));
  scene.add_closed("book_2", placed(painted(box({0.20, 0.028, 0.27}), Paint::book_blue),
                                    top + Vec3d(-0.40, 0.036, 0.05), -9.0));
  scene.add_closed(
      "sheet", placed(painted(box({0.21, 0.002, 0.297}), Paint::paper), top + Vec3d(0.0, 0.0, 0.12), 6.0));
  const auto lamp = top + Vec3d(0.46, 0.0, -0.10);
  const auto stem =
      lathe({{0.0, 0.0}, {0.085, 0.0}, {0.085, 0.015}, {0.010, 0.022}, {0.010, 0.26}, {0.0, 0.26}}, 12);
  scene.add_closed("lamp_stem", moved(painted(stem, Paint::brass), lamp));
  scene.add_closed("lamp_globe",
                   moved(painted(sphere(0.08, 16), Paint::lamp_study), lamp + Vec3d(0.0, 0.342, 0.0)));
  auto seat = painted(moved(box({0.42, 0.04, 0.42}), {0.0, 0.43, 0.0}), Paint::ochre_cloth);
  append(seat,
         painted(moved(turned_x(box({0.42, 0.36, 0.03}), -8.0), {0.0, 0.54, -0.20}), Paint::ochre_cloth));
  for (const auto x : {-0.18, 0.18}) {
    for (const auto z : {-0.18, 0.18})
      append(seat, painted(moved(box({0.035, 0.429, 0.035}), {x, 0.0, z}), Paint::walnut));
  }
  scene.add_closed("chair", placed(seat, {-0.28, on_floor, -0.22}, 196.0));
  auto shelves = Mesh{};
  for (const auto z : {-0.55, 0.55}) append(shelves, moved(box({0.28, 1.9, 0.03}), {1.558, on_floor, z}));
  for (auto k = 0; k < 5; ++k)
    append(shelves, moved(box({0.28, 0.025, 1.066}), {1.558, 0.08 + 0.44 * k, 0.0}));
  scene.add_closed("shelves", painted(shelves, Paint::birch));
  auto books = Mesh{};
  constexpr Paint bindings[] = {Paint::book_red,   Paint::book_blue,   Paint::book_green, Paint::book_yellow,
                                Paint::book_white, Paint::book_orange, Paint::plum_cloth};
  for (auto row = 0; row < 4; ++row) {
    auto z = -0.52;
    for (auto k = 0; k < 16; ++k) {
      const auto thick = 0.030 + 0.006 * ((3 * k + 5 * row) % 5),
                 high = 0.24 + 0.018 * ((2 * k + 3 * row) % 5);
      if ((k + row) % 7 != 6)
        append(books, painted(moved(box({0.17, high, thick}), {1.585, 0.107 + 0.44 * row, z + 0.5 * thick}),
                              bindings[(k * 3 + row) % 7]));
      z += thick + 0.004;
    }
  }
  scene.add_closed("books", books);
  scene.add_closed("rug", placed(painted(box({1.7, 0.012, 1.1}), Paint::rug_indigo), {-0.1, on_floor, 0.60}));
  scene.add_closed("vase", moved(painted(lathe({{0.0, 0.0},
                                                {0.06, 0.0},
                                                {0.10, 0.10},
                                                {0.08, 0.20},
                                                {0.04, 0.27},
                                                {0.05, 0.31},
                                                {0.0, 0.31}},
                                               14),
                                         Paint::glaze_turquoise),
                                 {-0.95, 0.95, room.low.z + 0.10}));
  scene.add_closed("picture_frame",
                   placed(painted(frame(0.6, 0.8, {{0.0, 0.001}, {0.03, 0.001}, {0.03, 0.03}, {0.0, 0.03}}),
                                  Paint::walnut),
                          {room.low.x, 1.55, 0.35}, 90.0));
  auto canvas = painted(
      panel({-0.299, -0.399, 0.02}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.20, 0.598}, {0.0, 0.30, 0.798}),
      Paint::ochre_cloth);
  canvas = painted(canvas, Paint::rug_indigo,
                   [](const Vec3d& p, const Vec3d&) { return p.x < -0.1 && p.y > -0.1; });
  scene.add_open("picture",
                 placed(painted(canvas, Paint::canvas,
                                [](const Vec3d& p, const Vec3d&) { return p.x > -0.1 && p.y > -0.1; }),
                        {room.low.x, 1.55, 0.35}, 90.0));
  scene.lights = {{PunctualLight::sun, "sun", {}, {-0.22, -0.72, 0.66}, 30'000.0, {1.0, 0.90, 0.74}},
                  {PunctualLight::spot,
                   "picture_spot",
                   {-0.5, 2.4, 0.35},
                   {-1.2, -0.85, 0.0},
                   600.0,
                   {1.0, 0.86, 0.66},
                   24.0}};
  scene.views = {{"the whole room", {1.35, 1.5, 1.42}, {-0.60, 1.02, -0.85}, 62.0}};
  return scene;
}

}  // namespace luxel::scenes
