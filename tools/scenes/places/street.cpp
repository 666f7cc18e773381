// SPDX-License-Identifier: Apache-2.0
// A lane of town houses in the morning sun, a church tower at its end.

#include <string>
#include <utility>

#include "scenes/furniture/garden.h"
#include "scenes/furniture/house.h"
#include "scenes/places/places.h"
#include "scenes/shapes/dice.h"
#include "scenes/shapes/sheets.h"
#include "scenes/shapes/solids.h"
#include "scenes/shapes/sweeping.h"
#include "scenes/shapes/turning.h"
#include "scenes/shapes/walls.h"

namespace luxel::scenes {
namespace {

constexpr auto kerb = 3.1;   // m, from the lane's axis
constexpr auto front = 5.2;  // m, of the houses
constexpr auto near_end = 13.0, far_end = -23.0;
constexpr auto pavement = 0.14;  // m above the lane

void add_ground(MadeScene& scene) {
  auto lane = panel({-kerb, 0.0, near_end}, {1.0, 0.0, 0.0}, {0.0, 0.0, -1.0}, steps({0.0, 2.0 * kerb}, 0.62),
                    steps({0.0, near_end - far_end}, 0.62));
  for (auto& triangle : lane.triangles) {
    const auto p = centroid(lane, triangle) + 100.0;
    const auto stone =
        static_cast<std::uint64_t>(p.x / 0.62) * 1000u + static_cast<std::uint64_t>(p.z / 0.62);
    constexpr Paint stones[] = {Paint::paving_1, Paint::paving_2, Paint::paving_3, Paint::stone_grey};
    triangle.paint = stones[static_cast<std::size_t>(4.0 * dice(170, stone))];
  }
  scene.add_open("lane", lane);
  for (const auto side : {-1.0, 1.0}) {
    const auto left = side < 0.0 ? -front - 0.4 : kerb + 0.17;
    const auto width = front + 0.4 - kerb - 0.17;
    const auto name = std::string(side < 0.0 ? "_left" : "_right");
    scene.add_open("pavement" + name,
                   painted(panel({left, pavement, near_end}, {1.0, 0.0, 0.0}, {0.0, 0.0, -1.0},
                                 steps({0.0, width}, 0.65), steps({0.0, near_end - far_end}, 0.9)),
                           Paint::paving_3));
    auto stones = Mesh{};
    for (auto z = far_end; z < near_end - 0.5; z += 1.0)
      append(stones, placed(chamfered_box({0.168, pavement + 0.004, 0.994}, 0.015),
                            {side * (kerb + 0.085), 0.001, z + 0.5}));
    scene.add_closed("kerb" + name, painted(stones, Paint::stone_pale));
  }
  scene.add_open("meadow", painted(panel({-70.0, -0.06, 60.0}, {1.0, 0.0, 0.0}, {0.0, 0.0, -1.0},
                                         steps({0.0, 140.0}, 7.0), steps({0.0, 140.0}, 7.0)),
                                   Paint::grass));
}

// A church tower that closes the lane.
void add_tower(MadeScene& scene) {
  const auto at = Vec3d(0.6, 0.0, far_end - 4.0);
  const auto face = Face{{-2.4, 0.0, 2.4}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 4.8, 15.0};
  const auto holes = std::vector<Hole>{{.left = 1.6, .right = 3.2, .low = 0.0, .high = 2.2, .rise = 0.9},
                                       {.left = 1.5, .right = 2.2, .low = 10.4, .high = 12.4, .rise = 0.4},
                                       {.left = 2.6, .right = 3.3, .low = 10.4, .high = 12.4, .rise = 0.4}};
  auto walls = Mesh{};
  auto sides = Mesh{};
  auto dark = Mesh{};
  for (auto k = 0; k < 4; ++k) {
    append(walls, turned_y(holed_face(face, holes, 0.8), 90.0 * k));
    append(sides, turned_y(reveals(face, holes, 0.6), 90.0 * k));
    for (const auto& hole : holes) {
      append(dark, turned_y(panel({face.origin.x + hole.left - 0.1, hole.low, 1.8}, {1.0, 0.0, 0.0},
                                  {0.0, 1.0, 0.0}, {0.0, hole.right - hole.left + 0.2},
                                  {0.0, hole.high + hole.rise - hole.low + 0.2}),
                            90.0 * k));
    }
  }
  scene.add_open("tower_walls", moved(painted(walls, Paint::stone_warm), at));
  scene.add_open("tower_reveals", moved(painted(sides, Paint::stone_pale), at));
  scene.add_open("tower_openings", moved(painted(dark, Paint::slate), at));
  auto trim = joined({moved(rounded_box({5.1, 0.30, 5.1}, 0.06), {0.0, 15.02, 0.0})});
  for (const auto y : {5.0, 9.4}) {
    for (auto k = 0; k < 4; ++k)
      append(trim, turned_y(placed(rounded_box({4.9, 0.20, 0.12}, 0.04), {0.0, y, 2.465}), 90.0 * k));
  }
  scene.add_closed("tower_trim", moved(painted(trim, Paint::stone_pale), at));
  const auto spire = lathe({{0.0, 15.33}, {3.55, 15.33}, {2.2, 16.6}, {1.1, 19.6}, {0.0, 23.5}}, 4);
  scene.add_closed("tower_spire", moved(painted(turned_y(spire, 45.0), Paint::slate), at));
  auto clock = turned_x(cylinder(0.95, 0.10, 36), 90.0);
  clock = painted(clock, Paint::plaster_white);
  auto hands = painted(
      joined({turned_z(moved(box({0.07, 0.78, 0.02}), {0.0, -0.08, 0.0}), -52.0),
              moved(turned_z(moved(box({0.10, 0.54, 0.02}), {0.0, -0.08, 0.0}), 25.0), {0.0, 0.0, 0.024})}),
      Paint::book_black);
  scene.add_closed("tower_clock",
                   moved(joined({moved(clock, {0.0, 7.7, 2.402}), moved(hands, {0.0, 7.7, 2.514})}), at));
}

void add_houses(MadeScene& scene) {
  constexpr Paint plasters[] = {Paint::plaster_ochre,  Paint::plaster_rose,  Paint::cream_wall,
                                Paint::plaster_blue,   Paint::plaster_green, Paint::plaster_white,
                                Paint::terracotta_wall};
  constexpr Paint doors[] = {Paint::door_blue, Paint::shutter_green, Paint::door_red, Paint::walnut};
  constexpr double widths[] = {6.4, 5.2, 7.2, 5.6, 6.6};
  for (const auto side : {-1.0, 1.0}) {
    auto z = 12.0;
    for (auto k = 0; k < 5; ++k) {
      const auto of = static_cast<std::uint64_t>(2 * k + (side > 0.0 ? 1 : 0));
      auto house = House{};
      house.width = widths[(static_cast<std::size_t>(k) + (side > 0.0 ? 2u : 0u)) % 5];
      house.columns = house.width > 6.0 ? 3 : 2;
      house.door_column = of % 3 == 0 ? 0 : (house.columns == 3 ? 1 : static_cast<int>(of % 2));
      house.storeys = of % 4 == 1 ? 3 : 2;
      house.arched_door = of % 3 == 1;
      house.gable_to_street = of % 3 == 2;
      house.shutters = of % 5 != 3;
      house.plaster = plasters[(3 * of + 1) % 7];
      house.door = doors[of % 4];
      const auto back = dice_between(0.0, 0.30, 171, of);  // out of line with its neighbours
      // A house's front runs to the right as one looks at it: towards -z on the left side, +z on the right.
      const auto at = side < 0.0 ? Vec3d(-front - back, pavement + 0.001, z)
                                 : Vec3d(front + back, pavement + 0.001, z - house.width);
      add_house(scene, (side < 0.0 ? "left_" : "right_") + std::to_string(k + 1), house, at,
                side < 0.0 ? 90.0 : -90.0);
      z -= house.width + 0.02;
    }
  }
}

void add_things(MadeScene& scene) {
  const auto y = pavement + 0.002;
  auto k = 0;
  for (const auto& at : {Vec3d(3.9, y, 2.2), Vec3d(-3.9, y, -7.4), Vec3d(3.9, y, -14.0)}) {
    const auto name = std::to_string(++k);
    const auto of = static_cast<std::uint64_t>(k);
    scene.add_closed("tree_wood_" + name, moved(tree_wood(5.2, of), at));
    scene.add_open("tree_leaves_" + name, moved(tree_leaves(5.2, of, 780), at));
  }
  k = 0;
  for (const auto& at : {Vec3d(-3.75, y, 4.4), Vec3d(3.75, y, -5.2), Vec3d(-3.75, y, -14.5)})
    scene.add_closed("lamp_post_" + std::to_string(++k), moved(street_lamp(), at));
  scene.add_closed("bench", placed(garden_bench(), {-4.55, y, 1.3}, 90.0));
  k = 0;
  for (const auto& at :
       {Vec3d(-4.6, y, 3.0), Vec3d(4.6, y, -0.6), Vec3d(4.6, y, 5.2), Vec3d(-4.6, y, -3.2)}) {
    const auto name = std::to_string(++k);
    scene.add_closed("planter_" + name, moved(planter(0.55), at));
    scene.add_closed("shrub_" + name,
                     moved(box_ball(0.30, static_cast<std::uint64_t>(k)), at + Vec3d(0.0, 0.512, 0.0)));
  }
}

}  // namespace

MadeScene street() {
  auto scene = MadeScene{.title = "A lane of town houses in the morning sun", .sky = "7,11,19"};
  add_ground(scene);
  add_houses(scene);
  add_tower(scene);
  add_things(scene);
  scene.lights = {{PunctualLight::sun, "sun", {}, {0.62, -0.62, -0.48}, 75'000.0, {1.0, 0.92, 0.78}}};
  scene.views = {{"down the lane", {1.1, 1.75, 11.6}, {-0.55, 3.35, -9.0}, 52.0},
                 {"the left side", {2.6, 1.7, 6.5}, {-5.0, 3.0, -1.5}, 58.0}};
  return scene;
}

}  // namespace luxel::scenes
