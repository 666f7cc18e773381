// SPDX-License-Identifier: Apache-2.0
// A classroom by daylight from one side, with the sun on the desks.

#include <string>

#include "scenes/furniture/pictures.h"
#include "scenes/furniture/plant.h"
#include "scenes/furniture/school.h"
#include "scenes/furniture/tables.h"
#include "scenes/places/places.h"
#include "scenes/shapes/dice.h"
#include "scenes/shapes/sheets.h"
#include "scenes/shapes/solids.h"
#include "scenes/shapes/sweeping.h"
#include "scenes/shapes/turning.h"
#include "scenes/shapes/walls.h"

namespace luxel::scenes {
namespace {

constexpr auto on_floor = 0.001;
constexpr auto window_width = 1.70, window_low = 0.95, window_high = 2.85;
constexpr double window_lefts[] = {0.60, 2.75, 4.90, 7.05};  // from the left wall's front corner

Room shell_of_classroom() {
  auto room = Room{.low = {-3.4, 0.0, -4.7}, .high = {3.4, 3.2, 4.7}, .thickness = 0.36};
  for (const auto left : window_lefts) {
    room.holes[left_wall].push_back(
        {.left = left, .right = left + window_width, .low = window_low, .high = window_high});
  }
  return room;
}

// Two sashes and a transom light, in the middle of the wall's depth; without glass.
Mesh window_woodwork() {
  constexpr auto bar = 0.055, joint = 0.001, thick = 0.06;
  constexpr auto w = window_width - 2.0 * joint, h = window_high - window_low - 2.0 * joint;
  auto mesh = frame(w - 2.0 * bar, h - 2.0 * bar, {{0.0, 0.0}, {bar, 0.0}, {bar, thick}, {0.0, thick}});
  const auto inner_w = w - 2.0 * bar - 2.0 * joint, inner_h = h - 2.0 * bar - 2.0 * joint;
  append(mesh, placed(box({inner_w, bar, 0.05}), {0.0, 0.20 * h, 0.03}));
  const auto below = 0.20 * h + 0.5 * inner_h - 2.0 * joint;
  append(mesh, placed(box({0.07, below, 0.05}), {0.0, -0.5 * inner_h, 0.03}));
  const auto above = 0.5 * inner_h - 0.20 * h - bar - joint;
  append(mesh, placed(box({0.05, above, 0.05}), {0.0, 0.20 * h + bar + joint, 0.03}));
  return mesh;
}

void add_shell(MadeScene& scene, const Room& room) {
  auto boards = room_floor(room, 0.7, 0.14);
  for (auto& triangle : boards.triangles) {
    const auto p = centroid(boards, triangle) - room.low;
    const auto row = static_cast<std::uint64_t>(p.z / 0.14);
    const auto board = static_cast<std::uint64_t>((p.x + 1.4 * dice(130, row)) / 1.4);
    constexpr Paint oaks[] = {Paint::floor_oak_1, Paint::floor_oak_2, Paint::floor_oak_3, Paint::floor_oak_4};
    triangle.paint = oaks[static_cast<std::size_t>(4.0 * dice(131, row, board))];
  }
  scene.add_open("floor", boards);
  scene.add_open("ceiling", painted(inner_wall(room, ceiling_side), Paint::plaster_white));
  const auto dado = [](const Vec3d& p, const Vec3d&) { return p.y < 1.0; };
  for (const auto& [name, wall] : {std::pair("wall_back", back_wall), std::pair("wall_right", right_wall),
                                   std::pair("wall_front", front_wall), std::pair("wall_left", left_wall)}) {
    scene.add_open(name,
                   painted(painted(inner_wall(room, wall), Paint::cream_wall), Paint::plaster_green, dado));
  }
  scene.add_open("reveals", painted(all_reveals(room), Paint::plaster_white));
  scene.add_open("outside", painted(outside(room), Paint::brick));
  scene.add_closed("skirting_boards", painted(skirting_boards(room), Paint::oak));
  auto woodwork = Mesh{};
  auto sills = Mesh{};
  auto radiators = Mesh{};
  for (const auto left : window_lefts) {
    const auto z = room.high.z - left - 0.5 * window_width;
    append(woodwork,
           placed(window_woodwork(), {room.low.x - 0.20, 0.5 * (window_low + window_high), z}, 90.0));
    append(sills, placed(rounded_box({window_width + 0.10, 0.03, 0.20}, 0.010),
                         {room.low.x + 0.101, window_low - 0.035, z}, 90.0));
    append(radiators, placed(radiator(1.2), {room.low.x + 0.14, 0.14, z}, 90.0));
  }
  scene.add_closed("window_frames", painted(woodwork, Paint::painted_wood));
  scene.add_closed("window_sills", painted(sills, Paint::painted_wood));
  scene.add_closed("radiators", radiators);
}

void add_desks(MadeScene& scene, const Room& room) {
  constexpr Paint covers[] = {Paint::book_red, Paint::book_blue, Paint::book_yellow, Paint::book_green};
  constexpr Paint seats[] = {Paint::coral_cloth, Paint::birch, Paint::glaze_turquoise};
  auto k = 0;
  for (auto row = 0; row < 4; ++row) {
    for (auto column = 0; column < 3; ++column, ++k) {
      const auto of = static_cast<std::uint64_t>(k);
      const auto at = Vec3d(-1.95 + 2.0 * column, on_floor, room.low.z + 3.1 + 1.55 * row);
      const auto name = std::to_string(k + 1);
      scene.add_closed("desk_" + name, placed(school_desk(), at, dice_between(-2.0, 2.0, 132, of)));
      for (auto seat = 0; seat < 2; ++seat) {
        const auto which = 2u * of + static_cast<std::uint64_t>(seat);
        const auto x = seat == 0 ? -0.33 : 0.33;
        scene.add_closed(
            "chair_" + name + (seat == 0 ? "a" : "b"),
            placed(school_chair(seats[which % 3]), at + Vec3d(x, 0.0, dice_between(0.46, 0.62, 133, which)),
                   180.0 + dice_between(-14.0, 14.0, 134, which)));
        if (dice(135, which) < 0.65) {
          scene.add_closed("book_" + name + (seat == 0 ? "a" : "b"),
                           placed(exercise_book(covers[which % 4]),
                                  at + Vec3d(x, 0.7212, dice_between(-0.04, 0.08, 136, which)),
                                  dice_between(-20.0, 20.0, 137, which)));
        }
      }
    }
  }
}

void add_front(MadeScene& scene, const Room& room) {
  const auto z = room.low.z;
  scene.add_closed("blackboard", placed(blackboard(3.6, 1.25), {-0.2, 1.62, z}));
  scene.add_closed("clock", placed(wall_clock(), {2.35, 2.55, z}));
  const auto desk = Vec3d(1.55, on_floor, z + 1.35);
  const auto boards = joined({placed(rounded_box({1.5, 0.035, 0.75}, 0.010), {0.0, 0.725, 0.0}),
                              placed(rounded_box({0.42, 0.70, 0.66}, 0.010), {-0.5, 0.02, 0.0}),
                              placed(rounded_box({0.42, 0.70, 0.66}, 0.010), {0.5, 0.02, 0.0}),
                              placed(box({0.56, 0.42, 0.02}), {0.0, 0.28, 0.2})});
  scene.add_closed("teachers_desk", placed(painted(boards, Paint::oak), desk));
  scene.add_closed("globe", placed(globe_on_stand(), desk + Vec3d(-0.50, 0.762, 0.05), 30.0));
  scene.add_closed("teachers_books", placed(lying_books(52, 4), desk + Vec3d(0.45, 0.762, 0.0), 70.0));
  scene.add_closed("teachers_chair", placed(school_chair(Paint::oak), desk + Vec3d(0.0, 0.0, -0.66), 8.0));
  scene.add_closed("apple",
                   placed(painted(sphere(0.038, 16), Paint::book_red), desk + Vec3d(0.12, 0.799, 0.12)));
  // A press along the right wall, with plants on it.
  const auto press = Vec3d(room.high.x - 0.27, on_floor, 0.6);
  auto doors = painted(placed(rounded_box({3.2, 0.86, 0.46}, 0.010), {0.0, 0.04, 0.0}), Paint::birch);
  for (auto k = 0; k < 4; ++k) {
    append(doors, painted(placed(rounded_box({0.76, 0.78, 0.018}, 0.006), {-1.185 + 0.79 * k, 0.08, 0.241}),
                          Paint::painted_wood));
    append(doors, painted(placed(box({0.012, 0.12, 0.02}),
                                 {-1.185 + 0.79 * k + (k % 2 == 0 ? 0.32 : -0.32), 0.46, 0.262}),
                          Paint::black_steel));
  }
  scene.add_closed("press", placed(doors, press, -90.0));
  const auto top = press + Vec3d(0.0, 0.902, 0.0);
  scene.add_closed("press_books", placed(lying_books(77, 6), top + Vec3d(0.0, 0.0, -1.1), 12.0));
  scene.add_closed("press_vase",
                   placed(bellied_vase(Paint::glaze_cobalt, 0.30), top + Vec3d(0.0, 0.0, -0.4)));
  scene.add_closed("press_twigs", placed(twig_stems(5), top + Vec3d(0.0, 0.30, -0.4)));
  scene.add_open("press_leaves", placed(twig_leaves(5), top + Vec3d(0.0, 0.30, -0.4)));
  scene.add_closed("press_bowl", placed(bowl(Paint::clay, 0.18), top + Vec3d(0.0, 0.0, 0.5)));
  const auto wall = Vec3d(room.high.x, 1.95, 0.0);
  constexpr Motif motifs[] = {Motif::rainbow, Motif::sunset, Motif::moon};
  for (auto k = 0; k < 5; ++k) {
    const auto at = wall + Vec3d(0.0, 0.0, -2.6 + 1.05 * k);
    scene.add_closed("picture_" + std::to_string(k + 1) + "_frame",
                     placed(picture_frame(0.54, 0.72, Paint::birch), at, -90.0));
    scene.add_open("picture_" + std::to_string(k + 1) + "_sheet",
                   placed(picture_sheet(0.54, 0.72, motifs[k % 3]), at, -90.0));
  }
}

// Ground before the windows returns light to the ceiling.
void add_ground(MadeScene& scene, const Room& room) {
  const auto y = room.low.y - room.thickness - 0.05;
  scene.add_open("meadow", painted(panel({-30.0, y, 24.0}, {1.0, 0.0, 0.0}, {0.0, 0.0, -1.0},
                                         steps({0.0, 50.0}, 5.0), steps({0.0, 48.0}, 5.0)),
                                   Paint::grass));
}

}  // namespace

MadeScene classroom() {
  auto scene = MadeScene{.title = "A classroom by daylight, with the sun on its desks", .sky = "9,12,17"};
  const auto room = shell_of_classroom();
  add_shell(scene, room);
  add_desks(scene, room);
  add_front(scene, room);
  add_ground(scene, room);
  scene.lights = {{PunctualLight::sun, "sun", {}, {0.80, -0.62, -0.42}, 55'000.0, {1.0, 0.91, 0.76}}};
  scene.views = {{"from the last row", {2.55, 1.60, 4.25}, {-0.75, 1.15, -2.2}, 50.0},
                 {"from the door", {2.9, 1.55, -3.9}, {-1.9, 1.0, 1.2}, 55.0}};
  return scene;
}

}  // namespace luxel::scenes
