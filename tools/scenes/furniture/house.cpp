// SPDX-License-Identifier: Apache-2.0
#include "scenes/furniture/house.h"

#include <algorithm>
#include <vector>

#include "scenes/shapes/dice.h"
#include "scenes/shapes/sheets.h"
#include "scenes/shapes/solids.h"
#include "scenes/shapes/split.h"
#include "scenes/shapes/sweeping.h"
#include "scenes/shapes/turning.h"
#include "scenes/shapes/walls.h"

namespace luxel::scenes {
namespace {

constexpr auto storey = 3.0;
constexpr auto reveal_depth = 0.18;
constexpr auto window_width = 0.95, window_height = 1.45, window_low = 0.95;
constexpr auto door_width = 1.10, door_height = 2.25;
constexpr auto base = 0.45;  // m of plinth of stone
constexpr auto joint = 0.001;

double eaves_of(const House& house) { return storey * house.storeys + 0.55; }
double roof_rise(const House& house) { return 0.42 * (house.gable_to_street ? house.width : house.depth); }

// Holes of the front by column and storey; the door is the first.
std::vector<Hole> holes_of(const House& house) {
  auto holes = std::vector<Hole>{};
  const auto pitch = house.width / house.columns;
  const auto door_middle = pitch * (house.door_column + 0.5);
  holes.push_back({.left = door_middle - 0.5 * door_width,
                   .right = door_middle + 0.5 * door_width,
                   .low = 0.0,
                   .high = house.arched_door ? door_height - 0.35 : door_height,
                   .rise = house.arched_door ? 0.45 : 0.0});
  for (auto level = 0; level < house.storeys; ++level) {
    for (auto column = 0; column < house.columns; ++column) {
      if (level == 0 && column == house.door_column) continue;
      const auto middle = pitch * (column + 0.5);
      const auto low = storey * level + window_low + 0.15;
      holes.push_back({.left = middle - 0.5 * window_width,
                       .right = middle + 0.5 * window_width,
                       .low = low,
                       .high = low + window_height});
    }
  }
  return holes;
}

// Sash bars before dark glass, in the hole's frame: its middle at the origin, the street towards +z.
Mesh window_bars() {
  constexpr auto w = window_width - 2.0 * joint, h = window_height - 2.0 * joint, bar = 0.055;
  auto mesh = frame(w - 2.0 * bar, h - 2.0 * bar, {{0.0, 0.0}, {bar, 0.0}, {bar, 0.05}, {0.0, 0.05}});
  append(mesh, placed(box({0.06, h - 2.0 * bar - 0.002, 0.045}), {0.0, -0.5 * h + bar + joint, 0.024}));
  for (const auto side : {-1.0, 1.0}) {
    for (const auto y : {-0.16, 0.26})
      append(mesh, placed(box({0.5 * w - bar - 0.034, 0.03, 0.03}),
                          {side * (0.25 * w + 0.002 - 0.5 * bar + 0.015), y, 0.024}));
  }
  return mesh;
}

Mesh shutter() {
  auto mesh = frame(0.36, window_height - 0.12, {{0.0, 0.0}, {0.05, 0.0}, {0.05, 0.035}, {0.0, 0.035}});
  constexpr auto slats = 9;
  for (auto k = 0; k < slats; ++k) {
    const auto y = (k - 0.5 * (slats - 1)) * (window_height - 0.14) / slats;
    append(mesh,
           moved(turned_x(moved(box({0.356, 0.012, 0.07}), {0.0, -0.006, 0.0}), 35.0), {0.0, y, 0.022}));
  }
  return mesh;
}

Mesh flower_box(std::uint64_t which) {
  auto mesh = painted(placed(chamfered_box({window_width + 0.06, 0.16, 0.18}, 0.02), {0.0, -0.165, 0.12}),
                      Paint::clay);
  for (auto k = 0; k < 22; ++k) {
    const auto of = static_cast<std::uint64_t>(k);
    const auto at = Vec3d((k / 21.0 - 0.5) * window_width, dice_between(0.01, 0.15, 160, which, of),
                          0.12 + dice_between(-0.07, 0.11, 161, which, of));
    const auto blossom = dice(162, which, of) < 0.45;
    append(mesh, painted(moved(sphere(blossom ? 0.045 : 0.06, 6), at),
                         blossom ? (which % 2 == 0 ? Paint::book_red : Paint::blossom) : Paint::foliage_2));
  }
  return mesh;
}

// Roofs overhang; a slab of 0.12 m on each slope, closed.
Mesh roof(const House& house) {
  const auto along = house.gable_to_street ? house.depth : house.width;
  const auto across = house.gable_to_street ? house.width : house.depth;
  const auto half = 0.5 * across;
  const auto rise = roof_rise(house);
  const auto slope = rise / half;
  constexpr auto over = 0.45, thick = 0.14;
  const auto eaves = eaves_of(house) + 0.02;
  auto mesh = Mesh{};
  for (const auto side : {-1.0, 1.0}) {
    auto outline = std::vector<glm::dvec2>{{0.002, rise},
                                           {half + over, -over * slope},
                                           {half + over, -over * slope + thick},
                                           {0.002, rise + thick * 1.1}};
    if (side < 0.0) {
      for (auto& p : outline) p.x = -p.x;
      std::reverse(outline.begin(), outline.end());
    }
    // Courses of tiles: each overlaps the one below by a step.
    append(mesh, moved(prism(outline, along + 0.5), {0.0, eaves, -0.25}));
    constexpr auto courses = 16;
    for (auto k = 0; k < courses; ++k) {
      const auto x0 = (half + over) * (k + 0.02) / courses, x1 = (half + over) * (k + 1.0) / courses;
      const auto y = [&](double x) { return eaves + rise - slope * x + thick * 1.1 + 0.002; };
      auto course =
          std::vector<glm::dvec2>{{x0, y(x0)}, {x1, y(x1)}, {x1, y(x1) + 0.05}, {x0, y(x0) + 0.012}};
      if (side < 0.0) {
        for (auto& p : course) p.x = -p.x;
        std::reverse(course.begin(), course.end());
      }
      append(mesh, moved(prism(course, along + 0.5), {0.0, 0.0, -0.25}));
    }
  }
  append(mesh, moved(turned_x(moved(cylinder(0.13, along + 0.5, 12), Vec3d(0.0)), 90.0),
                     {0.0, eaves + rise + thick + 0.03, -0.25}));
  // From running along z into place.
  return house.gable_to_street ? moved(mesh, {0.5 * house.width, 0.0, -house.depth})
                               : moved(turned_y(mesh, 90.0), {0.0, 0.0, -0.5 * house.depth});
}

Mesh gable(const Vec3d& left, const Vec3d& along, double width, double rise) {
  auto mesh = Mesh{};
  const auto a = mesh.add_point(left), b = mesh.add_point(left + width * along);
  mesh.add_triangle(a, b, mesh.add_point(left + 0.5 * width * along + Vec3d(0.0, rise, 0.0)));
  return split(mesh, 4);
}

}  // namespace

void add_house(MadeScene& scene, const std::string& name, const House& house, const Vec3d& at, double turn) {
  const auto put = [&](const Mesh& mesh) { return placed(mesh, at, turn); };
  const auto height = eaves_of(house);
  const auto w = house.width, d = house.depth;
  const auto holes = holes_of(house);
  const auto front = Face{Vec3d(0.0), {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, w, height};
  auto walls = joined({holed_face(front, holes, 0.75),
                       holed_face({{w, 0.0, 0.0}, {0.0, 0.0, -1.0}, {0.0, 1.0, 0.0}, d, height}, {}, 1.0),
                       holed_face({{w, 0.0, -d}, {-1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, w, height}, {}, 1.0),
                       holed_face({{0.0, 0.0, -d}, {0.0, 0.0, 1.0}, {0.0, 1.0, 0.0}, d, height}, {}, 1.0)});
  const auto rise = roof_rise(house);
  if (house.gable_to_street) {
    append(walls, gable({0.0, height, 0.0}, {1.0, 0.0, 0.0}, w, rise));
    append(walls, gable({w, height, -d}, {-1.0, 0.0, 0.0}, w, rise));
  } else {
    append(walls, gable({w, height, 0.0}, {0.0, 0.0, -1.0}, d, rise));
    append(walls, gable({0.0, height, -d}, {0.0, 0.0, 1.0}, d, rise));
  }
  scene.add_open(name + "_walls", put(painted(walls, house.plaster)));
  scene.add_open(name + "_reveals", put(painted(reveals(front, holes, reveal_depth), Paint::stone_pale)));
  auto panes = Mesh{};
  auto bars = Mesh{};
  auto woodwork = Mesh{};
  auto boxes = Mesh{};
  for (std::size_t k = 1; k < holes.size(); ++k) {
    const auto& hole = holes[k];
    const auto middle = Vec3d(0.5 * (hole.left + hole.right), 0.5 * (hole.low + hole.high), 0.0);
    append(panes, panel({hole.left, hole.low, -reveal_depth}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0},
                        {0.0, hole.right - hole.left}, {0.0, hole.high - hole.low}));
    append(bars, moved(window_bars(), middle - Vec3d(0.0, 0.0, reveal_depth - 0.006)));
    append(bars, placed(chamfered_box({window_width + 0.12, 0.05, 0.14}, 0.010),
                        {middle.x, hole.low - 0.052, 0.072}));
    if (house.shutters) {
      for (const auto side : {-1.0, 1.0})
        append(woodwork, moved(shutter(), middle + Vec3d(side * (0.5 * window_width + 0.25), 0.0, 0.012)));
    }
    const auto which =
        static_cast<std::uint64_t>(1000.0 * dice(163, k, static_cast<std::uint64_t>(at.x * 10.0 + 1000.0)));
    if (dice(164, which) < 0.55 && hole.low > storey)
      append(boxes, moved(flower_box(which), {middle.x, hole.low + 0.16, 0.03}));
  }
  scene.add_open(name + "_panes", put(painted(panes, Paint::glass_dark)));
  scene.add_closed(name + "_windows", put(painted(bars, Paint::painted_wood)));
  if (!woodwork.triangles.empty())
    scene.add_closed(name + "_shutters",
                     put(painted(woodwork, house.plaster == Paint::plaster_green ? Paint::door_blue
                                                                                 : Paint::shutter_green)));
  if (!boxes.triangles.empty()) scene.add_closed(name + "_flowers", put(boxes));
  const auto& hole = holes.front();
  const auto door_middle = 0.5 * (hole.left + hole.right);
  const auto top = hole.high + hole.rise;
  auto door =
      painted(placed(box({door_width - 0.004, top - 0.12, 0.05}), {door_middle, 0.122, -reveal_depth + 0.03}),
              house.door);
  for (const auto y : {0.30, 1.00})
    append(door, painted(placed(chamfered_box({0.66, y < 0.5 ? 0.55 : 0.75, 0.024}, 0.008),
                                {door_middle, y, -reveal_depth + 0.068}),
                         house.door));
  append(door,
         painted(moved(sphere(0.03, 12), {door_middle + 0.42, 1.05, -reveal_depth + 0.09}), Paint::brass));
  append(door, painted(placed(box({door_width - 0.004, 0.119, 0.40}), {door_middle, 0.002, 0.03}),
                       Paint::stone_grey));
  scene.add_closed(name + "_door", put(door));
  if (hole.rise > 0.0) {
    scene.add_open(name + "_door_back",
                   put(painted(panel({hole.left, 0.0, -reveal_depth}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0},
                                     {0.0, door_width}, {0.0, top + 0.02}),
                               Paint::glass_dark)));
  } else {
    scene.add_open(name + "_door_back", put(painted(panel({hole.left, 0.0, -reveal_depth}, {1.0, 0.0, 0.0},
                                                          {0.0, 1.0, 0.0}, {0.0, door_width}, {0.0, top}),
                                                    Paint::glass_dark)));
  }
  // A plinth on both sides of the door, a cornice under the eaves.
  auto trim = Mesh{};
  append(trim, placed(box({hole.left - 0.06, base, 0.05}), {0.5 * (hole.left - 0.06), joint, 0.027}));
  append(trim,
         placed(box({w - hole.right - 0.06, base, 0.05}), {0.5 * (w + hole.right + 0.06), joint, 0.027}));
  append(trim, placed(rounded_box({w, 0.16, 0.14}, 0.03), {0.5 * w, height - 0.20, 0.072}));
  scene.add_closed(name + "_trim", put(painted(trim, Paint::stone_warm)));
  scene.add_closed(name + "_roof", put(painted(roof(house), Paint::roof_tile)));
  const auto chimney =
      joined({placed(box({0.55, rise + 1.2, 0.55}), {0.28 * w, height + 0.02, -0.42 * d}),
              placed(box({0.66, 0.10, 0.66}), {0.28 * w, height + rise + 1.222, -0.42 * d})});
  scene.add_closed(name + "_chimney", put(painted(chimney, Paint::brick)));
}

}  // namespace luxel::scenes
