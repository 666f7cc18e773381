// SPDX-License-Identifier: Apache-2.0
#include "scenes/places/reading_room.h"

#include "scenes/furniture/bookcase.h"
#include "scenes/furniture/curtains.h"
#include "scenes/furniture/dining.h"
#include "scenes/furniture/lamps.h"
#include "scenes/furniture/pictures.h"
#include "scenes/furniture/plant.h"
#include "scenes/furniture/seating.h"
#include "scenes/furniture/tables.h"
#include "scenes/places/places.h"
#include "scenes/places/reading_room_shell.h"
#include "scenes/shapes/split.h"

namespace luxel::scenes {
namespace {

constexpr auto on_floor = 0.001;  // m; things float by a hair: no two faces in one place
constexpr auto on_rug = on_floor + rug_height + 0.001;

using Objects = std::vector<Object>;

void add_lamp(Objects& objects, const std::string& name, const Lamp& lamp, const Vec3d& at,
              double turn = 0.0) {
  objects.push_back({name + "_stand", placed(lamp.stand, at, turn)});
  objects.push_back({name + "_bulb", placed(lamp.bulb, at, turn)});
  if (!lamp.shade.triangles.empty())
    objects.push_back({name + "_shade", placed(lamp.shade, at, turn), false});
}

void add_picture(Objects& objects, const std::string& name, double width, double height, Motif motif,
                 const Vec3d& at, double turn) {
  objects.push_back({name + "_frame", placed(picture_frame(width, height, Paint::oak), at, turn)});
  objects.push_back({name + "_sheet", placed(picture_sheet(width, height, motif), at, turn), false});
}

void add_sofa_corner(Objects& objects) {
  const auto at = Vec3d(-2.98, on_floor, 0.25);
  const auto place = [&](const Mesh& mesh) { return placed(mesh, at, 90.0); };
  objects.push_back({"sofa", place(sofa({.width = 2.1, .seats = 3, .cloth = Paint::teal_cloth}))});
  const auto seat = 0.462;
  objects.push_back({"sofa_pillow_1",
                     place(placed(throw_pillow(Paint::ochre_cloth, 0.42, 24.0), {-0.66, seat, 0.22}, 14.0))});
  objects.push_back({"sofa_pillow_2",
                     place(placed(throw_pillow(Paint::coral_cloth, 0.36, 30.0), {-0.40, seat, 0.33}, -6.0))});
  objects.push_back({"sofa_pillow_3",
                     place(placed(throw_pillow(Paint::ochre_cloth, 0.42, 24.0), {0.66, seat, 0.22}, -12.0))});
  const auto table = Vec3d(-3.10, on_floor, 1.68);
  objects.push_back({"side_table", placed(side_table(), table)});
  add_lamp(objects, "table_lamp", table_lamp(), table + Vec3d(0.0, side_table_height + 0.001, 0.0));
  add_picture(objects, "picture_sunset", 0.54, 0.72, Motif::sunset, {room_low.x, 1.66, 0.97}, 90.0);
  add_picture(objects, "picture_rainbow", 0.54, 0.72, Motif::rainbow, {room_low.x, 1.66, 0.25}, 90.0);
  add_picture(objects, "picture_moon", 0.54, 0.72, Motif::moon, {room_low.x, 1.66, -0.47}, 90.0);
}

void add_hearth(Objects& objects) {
  objects.push_back({"rug", placed(rug(), {-1.12, on_floor, 0.28})});
  const auto table = Vec3d(-1.42, on_rug, 0.28);
  objects.push_back({"coffee_table", placed(coffee_table(), table, 90.0)});
  const auto top = table + Vec3d(0.0, coffee_table_height + 0.001, 0.0);
  objects.push_back({"coffee_table_books", placed(lying_books(3, 3), top + Vec3d(0.05, 0.0, -0.30), 80.0)});
  objects.push_back({"coffee_table_vase",
                     placed(bellied_vase(Paint::glaze_turquoise, 0.20), top + Vec3d(-0.08, 0.0, 0.05))});
  objects.push_back({"coffee_table_twigs", placed(twig_stems(1), top + Vec3d(-0.08, 0.20, 0.05))});
  objects.push_back({"coffee_table_leaves", placed(twig_leaves(1), top + Vec3d(-0.08, 0.20, 0.05)), false});
  objects.push_back({"coffee_table_mug", placed(mug(Paint::coral_cloth), top + Vec3d(0.14, 0.0, 0.28))});
  objects.push_back({"pouf", placed(pouf(Paint::coral_cloth), {-0.42, on_rug, 0.82}, 10.0)});
}

void add_reading_corner(Objects& objects) {
  const auto chair_at = Vec3d(-0.72, on_floor, -1.28);
  objects.push_back(
      {"armchair", placed(sofa({.width = 0.98, .seats = 1, .cloth = Paint::ochre_cloth}), chair_at, -24.0)});
  const auto pillow = placed(throw_pillow(Paint::plum_cloth, 0.38, 26.0), {0.04, 0.462, 0.20}, 8.0);
  objects.push_back({"armchair_pillow", placed(pillow, chair_at, -24.0)});
  const auto bookcase_at = Vec3d(-2.15, on_floor, room_low.z + 0.022);
  objects.push_back({"bookcase", placed(bookcase(), bookcase_at)});
  objects.push_back({"books", placed(books_of_bookcase(), bookcase_at)});
  add_lamp(objects, "floor_lamp", floor_lamp(), {0.02, on_floor, -1.72}, -48.0);
  const auto pot = Vec3d(-0.86, on_floor, -2.10);
  objects.push_back({"plant_pot", placed(plant_pot(), pot)});
  objects.push_back({"plant_stems", placed(plant_stems(), pot)});
  objects.push_back({"plant_leaves", placed(plant_leaves(), pot), false});
}

void add_dining_corner(Objects& objects) {
  const auto table = Vec3d(1.42, on_floor, -0.72);
  objects.push_back({"dining_table", placed(dining_table(), table)});
  constexpr auto first = 28.0;  // degrees; so that no chair hides another from the door
  for (auto k = 0; k < 4; ++k) {
    const auto turn = first + 90.0 * k;
    const auto name = std::to_string(k + 1);
    const auto seat = k % 2 == 0 ? Paint::coral_cloth : Paint::teal_cloth;
    const auto pushed = moved(chair(seat), {0.0, 0.0, k == 2 ? -0.86 : -0.70});
    objects.push_back({"chair_" + name, placed(pushed, table, turn)});
    const auto setting = moved(place_setting(), {0.0, dining_table_height + 0.001, -0.40});
    objects.push_back({"place_setting_" + name, placed(setting, table, turn)});
  }
  const auto top = table + Vec3d(0.0, dining_table_height + 0.001, 0.0);
  objects.push_back({"fruit_bowl", placed(fruit_bowl(Paint::glaze_cobalt), top)});
  add_lamp(objects, "pendant_lamp", pendant_lamp(), {table.x, room_high.y, table.z});
}

void add_window_side(Objects& objects) {
  const auto z = room_low.z + 0.23;
  objects.push_back(
      {"curtain_left", placed(curtain(0.52, 2.48, 4), {window_middle.x - 1.38, 0.0, z}), false});
  objects.push_back(
      {"curtain_right", placed(curtain(0.52, 2.48, 4), {window_middle.x + 0.86, 0.0, z}), false});
  objects.push_back({"curtain_rod", placed(curtain_rod(2.9), {window_middle.x, 2.50, z})});
}

void add_sideboard_side(Objects& objects) {
  const auto at = Vec3d(room_high.x - 0.24, on_floor, -0.2);
  objects.push_back({"sideboard", placed(sideboard(), at, -90.0)});
  const auto top = at + Vec3d(0.0, sideboard_height + 0.001, 0.0);
  objects.push_back({"sideboard_vase", placed(vase(Paint::glaze_cobalt, 0.34), top + Vec3d(0.0, 0.0, -0.5))});
  objects.push_back({"sideboard_books", placed(lying_books(9, 4), top + Vec3d(0.0, 0.0, 0.4), 75.0)});
  add_picture(objects, "picture_evening", 0.80, 0.56, Motif::sunset, {room_high.x, 1.60, -0.2}, -90.0);
}

void add_corridor_things(Objects& objects) {
  add_lamp(objects, "corridor_lamp", globe_lamp(), {-4.36, corridor_high.y, door_middle.z});
  add_picture(objects, "picture_corridor", 0.50, 0.66, Motif::moon, {corridor_low.x, 1.60, -2.42}, 90.0);
  const auto pot = Vec3d(-4.70, on_floor, -3.15);
  objects.push_back({"corridor_vase", placed(bellied_vase(Paint::glaze_cobalt, 0.55), pot)});
}

}  // namespace

std::vector<Object> reading_room(int detail) {
  auto objects = shell();
  for (auto& object : woodwork()) objects.push_back(std::move(object));
  add_sofa_corner(objects);
  add_hearth(objects);
  add_reading_corner(objects);
  add_dining_corner(objects);
  add_window_side(objects);
  add_sideboard_side(objects);
  add_corridor_things(objects);
  for (auto& object : objects) {
    object.mesh = rounded(object.mesh);
    if (detail > 1) object.mesh = rounded(split(object.mesh, detail));
  }
  return objects;
}

MadeScene reading_room_scene() {
  auto scene = MadeScene{.title = "A reading room in the evening", .objects = reading_room()};
  scene.views = {{"the whole room", {3.05, 1.50, 2.20}, {-0.95, 1.00, -1.15}, 51.0},
                 {"the reading corner", {0.90, 1.35, 2.00}, {-1.60, 0.95, -1.60}, 45.0},
                 {"the dining table", {-1.60, 1.45, 1.90}, {1.60, 0.95, -1.20}, 45.0}};
  return scene;
}

}  // namespace luxel::scenes
