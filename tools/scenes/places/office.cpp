// SPDX-License-Identifier: Apache-2.0
// An office of eight places under ceiling luminaires, in the evening.

#include "scenes/furniture/office.h"

#include "scenes/furniture/pictures.h"
#include "scenes/furniture/plant.h"
#include "scenes/furniture/school.h"
#include "scenes/furniture/tables.h"
#include "scenes/places/places.h"
#include "scenes/shapes/dice.h"
#include "scenes/shapes/sheets.h"
#include "scenes/shapes/solids.h"
#include "scenes/shapes/sweeping.h"
#include "scenes/shapes/walls.h"

namespace luxel::scenes {
namespace {

constexpr auto on_floor = 0.001;
constexpr auto inside = Room{.low = {-4.8, 0.0, -3.6}, .high = {4.8, 2.8, 3.6}, .thickness = 0.25};
constexpr auto door = Hole{.left = 5.4, .right = 6.4, .low = 0.0, .high = 2.1};  // in the left wall

void add_shell(MadeScene& scene) {
  // Carpet tiles of 0.6 m in two greys.
  auto carpet = room_floor(inside, 0.6, 0.6);
  for (auto& triangle : carpet.triangles) {
    const auto p = centroid(carpet, triangle) - inside.low;
    const auto tile = static_cast<std::uint64_t>(p.x / 0.6) * 100u + static_cast<std::uint64_t>(p.z / 0.6);
    triangle.paint = dice(120, tile) < 0.16 ? Paint::carpet_blue : Paint::carpet_grey;
  }
  scene.add_open("floor", carpet);
  scene.add_open("ceiling", painted(inner_wall(inside, ceiling_side, 0.6), Paint::plaster_white));
  scene.add_open("wall_back", painted(inner_wall(inside, back_wall), Paint::plaster_white));
  scene.add_open("wall_right", painted(inner_wall(inside, right_wall), Paint::plaster_blue));
  scene.add_open("wall_front", painted(inner_wall(inside, front_wall), Paint::plaster_white));
  scene.add_open("wall_left", painted(inner_wall(inside, left_wall), Paint::plaster_white));
  scene.add_open("outside", painted(outside(inside), Paint::concrete));
  auto with_door = inside;
  with_door.holes[left_wall] = {door};
  scene.add_closed("skirting_boards", painted(skirting_boards(with_door, 0.07), Paint::steel_grey));
  // A closed door in its casing, on the wall.
  const auto x = inside.low.x;
  const auto z = inside.high.z - 0.5 * (door.left + door.right);
  const auto leaf =
      painted(placed(rounded_box({0.90, 2.04, 0.045}, 0.006), {0.0, on_floor + 0.004, 0.026}), Paint::birch);
  const auto casing = painted(
      moved(frame(0.92, 2.06, {{0.0, 0.0}, {0.07, 0.0}, {0.07, 0.03}, {0.0, 0.03}}), {0.0, 1.105, 0.002}),
      Paint::steel_grey);
  const auto handle =
      painted(moved(rounded_box({0.13, 0.018, 0.018}, 0.006), {0.34, 1.05, 0.085}), Paint::steel_grey);
  scene.add_closed("door", placed(joined({leaf, casing, handle}), {x, 0.0, z}, 90.0));
}

void add_luminaires(MadeScene& scene) {
  auto housings = Mesh{};
  auto panels = Mesh{};
  for (const auto x : {-3.3, -1.1, 1.1, 3.3}) {
    for (const auto z : {-2.4, 0.0, 2.4}) {
      const auto at = Vec3d(x, inside.high.y, z);
      append(housings, moved(ceiling_luminaire_housing(), at));
      append(panels, moved(ceiling_luminaire_panel(Paint::lamp_office), at));
    }
  }
  scene.add_closed("luminaire_housings", housings);
  scene.add_open("luminaires", panels);
}

void add_place(MadeScene& scene, int k, const Vec3d& at, double turn) {
  const auto number = std::to_string(k);
  const auto of = static_cast<std::uint64_t>(k);
  const auto put = [&](const Mesh& mesh, const Vec3d& where, double by = 0.0) {
    return placed(placed(mesh, where, by), at, turn);
  };
  constexpr auto top = desk_height + 0.001;
  scene.add_closed("desk_" + number, put(office_desk(), {}));
  scene.add_closed("chair_" + number,
                   put(office_chair(k % 3 == 0 ? Paint::ochre_cloth : Paint::teal_cloth),
                       {dice_between(-0.25, 0.10, 121, of), 0.0, dice_between(0.58, 0.86, 122, of)},
                       180.0 + dice_between(-32.0, 32.0, 123, of)));
  scene.add_closed("monitor_" + number,
                   put(monitor(), {-0.12, top, -0.20}, dice_between(-10.0, 10.0, 124, of)));
  scene.add_closed("keyboard_" + number, put(keyboard(), {-0.12, top, 0.14}));
  scene.add_closed("papers_" + number, put(paper_stack(of), {0.52, top, dice_between(-0.12, 0.14, 125, of)},
                                           dice_between(-15.0, 15.0, 126, of)));
  if (k % 2 == 0) {
    scene.add_closed("mug_" + number,
                     put(mug(k % 4 == 0 ? Paint::coral_cloth : Paint::glaze_cobalt), {-0.56, top, 0.08}));
  } else {
    scene.add_closed("books_" + number, put(lying_books(60 + of, 3), {-0.58, top, -0.18}, 80.0));
  }
  if (k % 3 == 1) scene.add_closed("bin_" + number, put(waste_bin(), {0.98, 0.0, 0.30}));
}

void add_things(MadeScene& scene) {
  // Two islands of four, with a low partition between those who face each other.
  auto k = 0;
  for (const auto x : {-1.72, 1.72}) {
    for (const auto side : {-1.0, 1.0}) {
      add_place(scene, ++k, {x - 0.81, on_floor, 0.44 * side + 0.1}, side > 0.0 ? 0.0 : 180.0);
      add_place(scene, ++k, {x + 0.81, on_floor, 0.44 * side + 0.1}, side > 0.0 ? 0.0 : 180.0);
    }
    scene.add_closed(x < 0.0 ? "partition_1" : "partition_2",
                     placed(partition(3.1, 1.12, Paint::sage_wall), {x, on_floor, 0.1}));
  }
  for (auto i = 0; i < 4; ++i) {
    scene.add_closed("cabinet_" + std::to_string(i + 1),
                     placed(filing_cabinet(i == 2 ? Paint::ochre_cloth : Paint::plastic_white),
                            {-3.9 + 0.82 * i, on_floor, inside.low.z + 0.26}));
  }
  const auto on_cabinet = on_floor + 1.202;
  scene.add_closed("cabinet_vase", placed(bellied_vase(Paint::glaze_turquoise, 0.26),
                                          {-3.9, on_cabinet, inside.low.z + 0.28}));
  scene.add_closed("cabinet_books",
                   placed(lying_books(31, 5), {-2.3, on_cabinet, inside.low.z + 0.30}, 84.0));
  scene.add_closed("twigs", placed(twig_stems(3), {-3.9, on_cabinet + 0.26, inside.low.z + 0.28}));
  scene.add_open("twig_leaves", placed(twig_leaves(3), {-3.9, on_cabinet + 0.26, inside.low.z + 0.28}));
  for (auto i = 0; i < 2; ++i) {
    const auto pot = i == 0 ? Vec3d(4.25, on_floor, -3.05) : Vec3d(4.3, on_floor, 3.0);
    const auto turn = 60.0 * i;
    const auto name = std::to_string(i + 1);
    scene.add_closed("plant_pot_" + name, placed(plant_pot(), pot, turn));
    scene.add_closed("plant_stems_" + name, placed(plant_stems(), pot, turn));
    scene.add_open("plant_leaves_" + name, placed(plant_leaves(), pot, turn));
  }
  const auto z = inside.low.z;
  const auto add_picture = [&](const char* name, Motif motif, const Vec3d& at, double turn) {
    scene.add_closed(std::string(name) + "_frame", placed(picture_frame(0.70, 0.94, Paint::oak), at, turn));
    scene.add_open(std::string(name) + "_sheet", placed(picture_sheet(0.70, 0.94, motif), at, turn));
  };
  add_picture("picture_moon", Motif::moon, {0.6, 1.62, z}, 0.0);
  add_picture("picture_rainbow", Motif::rainbow, {1.6, 1.62, z}, 0.0);
  add_picture("picture_sunset", Motif::sunset, {2.6, 1.62, z}, 0.0);
  scene.add_closed("clock", placed(wall_clock(), {inside.high.x, 2.15, 0.1}, -90.0));
}

}  // namespace

MadeScene office() {
  auto scene = MadeScene{.title = "An office of eight places under twelve ceiling luminaires"};
  add_shell(scene);
  add_luminaires(scene);
  add_things(scene);
  scene.views = {{"the whole office", {-4.45, 1.62, 3.25}, {0.55, 0.98, -0.85}, 48.0},
                 {"the cabinets", {3.6, 1.5, 2.6}, {-1.6, 0.95, -2.6}, 45.0}};
  return scene;
}

}  // namespace luxel::scenes
