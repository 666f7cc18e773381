// SPDX-License-Identifier: Apache-2.0
// A cloister: arcades round a garden with a fountain.

#include <cmath>
#include <string>

#include "scenes/furniture/church.h"
#include "scenes/furniture/garden.h"
#include "scenes/places/places.h"
#include "scenes/shapes/dice.h"
#include "scenes/shapes/sheets.h"
#include "scenes/shapes/solids.h"
#include "scenes/shapes/walls.h"

namespace luxel::scenes {
namespace {

constexpr auto garden = 6.3;      // m, from the middle to the arcade's front
constexpr auto wall = 0.42;       // m, of the arcade
constexpr auto walk = 9.3;        // m, from the middle to the inner wall of the building
constexpr auto springing = 2.35;  // m
constexpr auto ceiling = 4.25;    // m, of the walk
constexpr auto eaves = 8.2;       // m, of the building
constexpr auto bays = 5;
constexpr auto bay = 2.0 * garden / bays;
constexpr auto floor_height = 0.15;

// One side of four, at -z, facing +z; the others are turned.
Mesh on_all_sides(const Mesh& side) {
  auto mesh = Mesh{};
  for (auto k = 0; k < 4; ++k) append(mesh, turned_y(side, 90.0 * k));
  return mesh;
}

void add_arcades(MadeScene& scene) {
  const auto face = Face{{-garden, springing, -garden},
                         {1.0, 0.0, 0.0},
                         {0.0, 1.0, 0.0},
                         2.0 * garden,
                         ceiling - springing + 0.35};
  auto holes = std::vector<Hole>{};
  for (auto k = 0; k < bays; ++k)
    holes.push_back(
        {.left = bay * k + 0.22, .right = bay * (k + 1) - 0.22, .low = 0.0, .high = 0.0, .rise = 1.15});
  // The wall behind is longer by its thickness on both sides: corner piers close the gap.
  auto side = holed_wall(face, holes, wall, 0.6);
  auto undersides = Mesh{};
  for (auto k = 0; k <= bays; ++k) {
    const auto low = k == 0 ? 0.0 : bay * k - 0.22, high = k == bays ? 2.0 * garden : bay * k + 0.22;
    append(undersides, panel({-garden + low, springing, -garden - wall}, {1.0, 0.0, 0.0}, {0.0, 0.0, 1.0},
                             {0.0, high - low}, {0.0, wall}));
  }
  append(side, undersides);
  scene.add_open("arcades", painted(on_all_sides(side), Paint::stone_pale));
  auto columns = Mesh{};
  auto piers = Mesh{};
  for (auto k = 0; k < 4; ++k) {
    for (auto i = 1; i < bays; ++i) {
      append(columns, turned_y(moved(column(0.125, springing - floor_height - 0.003, Paint::stone_warm),
                                     {-garden + bay * i, floor_height + 0.002, -garden - 0.5 * wall}),
                               90.0 * k));
    }
    append(piers, turned_y(moved(box({wall, springing - floor_height - 0.003, wall}),
                                 {-garden - 0.5 * wall, floor_height + 0.002, -garden - 0.5 * wall}),
                           90.0 * k));
    append(piers, turned_y(moved(box({wall - 0.002, ceiling - springing + 0.35, wall - 0.002}),
                                 {-garden - 0.5 * wall, springing, -garden - 0.5 * wall}),
                           90.0 * k));
    for (const auto x : {-garden + 0.111, garden - 0.111}) {
      append(piers, turned_y(moved(box({0.218, springing - floor_height - 0.003, wall}),
                                   {x, floor_height + 0.002, -garden - 0.5 * wall}),
                             90.0 * k));
    }
  }
  scene.add_closed("columns", columns);
  scene.add_closed("piers", painted(piers, Paint::stone_pale));
  // A wall on which the columns stand, open in the middle bay.
  auto parapets = Mesh{};
  for (auto i = 0; i < bays; ++i) {
    if (i == bays / 2) continue;
    append(parapets, moved(chamfered_box({bay - 0.44, 0.45, 0.30}, 0.025),
                           {-garden + bay * (i + 0.5), floor_height + 0.002, -garden - 0.5 * wall}));
  }
  scene.add_closed("parapets", painted(on_all_sides(parapets), Paint::stone_warm));
}

void add_walks(MadeScene& scene) {
  const auto depth = walk - garden;
  // A square with a square hole.
  const auto ring = [](double outer, double inner, double y, bool faces_up) {
    const auto a = steps({-outer, -inner, inner, outer}, 0.62);
    const auto skip = [=](double s, double t) { return std::abs(s) < inner && std::abs(t) < inner; };
    return faces_up ? panel({0.0, y, 0.0}, {1.0, 0.0, 0.0}, {0.0, 0.0, -1.0}, a, a, skip)
                    : panel({0.0, y, 0.0}, {1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, a, a, skip);
  };
  auto floor = ring(walk, garden - 0.15, floor_height, true);
  for (auto& triangle : floor.triangles) {
    const auto p = centroid(floor, triangle) + 50.0;
    const auto i = static_cast<int>(p.x / 0.62), j = static_cast<int>(p.z / 0.62);
    triangle.paint = (i + j) % 2 == 0 ? Paint::stone_warm : Paint::terracotta_wall;
  }
  scene.add_open("walk_floor", floor);
  const auto step_face = panel({-garden + 0.15, 0.0, -garden + 0.15}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0},
                               steps({0.0, 2.0 * garden - 0.3}, 0.62), {0.0, floor_height});
  scene.add_open("walk_step", painted(on_all_sides(step_face), Paint::stone_grey));
  scene.add_open("walk_ceiling", painted(ring(walk, garden + wall, ceiling, false), Paint::oak));
  // Beams across the walk.
  auto beams = Mesh{};
  for (auto i = -5; i <= 5; ++i)
    append(beams, moved(box({0.12, 0.16, depth - wall - 0.004}),
                        {1.15 * i, ceiling - 0.162, -0.5 * (walk + garden + wall)}));
  scene.add_closed("walk_beams", painted(on_all_sides(beams), Paint::walnut));
  // A lean-to of tiles from the arcade up to the building.
  auto roofs = Mesh{};
  const auto low = ceiling + 0.36, high = ceiling + 1.25;
  constexpr auto courses = 9;
  for (auto k = 0; k < courses; ++k) {
    // From the eaves, which overhang the arcade, to the building; mitred at the corners.
    const auto at = [&](double t, double lift) {
      return Vec3d(glm::mix(garden - 0.35, walk, t), glm::mix(low - 0.1, high, t) + lift, 0.0);
    };
    const auto a = at((k + 0.0) / courses, 0.05), b = at((k + 1.0) / courses, 0.0);
    auto course = Mesh{};
    for (auto i = 0; i < 12; ++i) {
      const auto s = -1.0 + i / 6.0, t = -1.0 + (i + 1) / 6.0;
      course.add_quad(course.add_point({s * a.x, a.y, -a.x}), course.add_point({t * a.x, a.y, -a.x}),
                      course.add_point({t * b.x, b.y, -b.x}), course.add_point({s * b.x, b.y, -b.x}));
      // The course's edge, and for the lowest one the eaves.
      course.add_quad(course.add_point({s * a.x, a.y - 0.05, -a.x}),
                      course.add_point({t * a.x, a.y - 0.05, -a.x}), course.add_point({t * a.x, a.y, -a.x}),
                      course.add_point({s * a.x, a.y, -a.x}));
    }
    append(roofs, course);
  }
  const auto e = garden - 0.35;
  roofs = painted(roofs, Paint::roof_tile);
  // The underside of the eaves.
  auto under = Mesh{};
  under.add_quad(under.add_point({-e, low - 0.10, -e}), under.add_point({-garden, low - 0.01, -garden}),
                 under.add_point({garden, low - 0.01, -garden}), under.add_point({e, low - 0.10, -e}));
  scene.add_open("lean_to_roofs", on_all_sides(joined({roofs, painted(under, Paint::oak)})));
}

void add_building(MadeScene& scene) {
  const auto face =
      Face{{-walk, floor_height, -walk}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 2.0 * walk, eaves - floor_height};
  auto holes = std::vector<Hole>{};
  for (auto k = 0; k < 5; ++k) {
    const auto middle = walk + 3.1 * (k - 2);
    holes.push_back({.left = middle - 0.5, .right = middle + 0.5, .low = 5.75, .high = 7.15, .rise = 0.35});
  }
  holes.push_back({.left = walk - 0.7, .right = walk + 0.7, .low = 0.0, .high = 2.1, .rise = 0.6});
  auto panes = Mesh{};
  for (const auto& hole : holes) {
    append(panes, panel({face.origin.x + hole.left - 0.02, face.origin.y + hole.low, -walk - 0.22},
                        {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, hole.right - hole.left + 0.04},
                        {0.0, hole.high + hole.rise - hole.low + 0.04}));
  }
  const auto is_door = [](const Vec3d& p, const Vec3d&) { return p.y < 4.0; };
  scene.add_open("walls", painted(on_all_sides(holed_face(face, holes, 0.8)), Paint::plaster_ochre));
  scene.add_open("reveals", painted(on_all_sides(reveals(face, holes, 0.22)), Paint::stone_pale));
  scene.add_open("panes_and_doors",
                 painted(painted(on_all_sides(panes), Paint::glass_dark), Paint::walnut, is_door));
  auto trim = Mesh{};
  auto roof = Mesh{};
  append(trim, moved(rounded_box({2.0 * walk - 0.4, 0.22, 0.18}, 0.05), {0.0, eaves - 0.24, -walk + 0.092}));
  for (auto k = 0; k < 5; ++k)
    append(trim, moved(rounded_box({1.25, 0.08, 0.16}, 0.02), {3.1 * (k - 2), 5.81, -walk + 0.082}));
  scene.add_closed("trim", painted(on_all_sides(trim), Paint::stone_pale));
  constexpr auto courses = 10;
  for (auto k = 0; k < courses; ++k) {
    const auto r0 = glm::mix(walk - 0.4, walk + 4.2, k / double(courses)),
               r1 = glm::mix(walk - 0.4, walk + 4.2, (k + 1) / double(courses));
    const auto y0 = glm::mix(eaves - 0.02, eaves + 2.4, k / double(courses)),
               y1 = glm::mix(eaves - 0.02, eaves + 2.4, (k + 1) / double(courses));
    roof.add_quad(roof.add_point({-r0, y0 + 0.06, -r0}), roof.add_point({r0, y0 + 0.06, -r0}),
                  roof.add_point({r1, y1, -r1}), roof.add_point({-r1, y1, -r1}));
    roof.add_quad(roof.add_point({-r0, y0, -r0}), roof.add_point({r0, y0, -r0}),
                  roof.add_point({r0, y0 + 0.06, -r0}), roof.add_point({-r0, y0 + 0.06, -r0}));
  }
  roof.add_quad(roof.add_point({-walk + 0.4, eaves - 0.02, -walk + 0.4}),
                roof.add_point({-walk, eaves, -walk}), roof.add_point({walk, eaves, -walk}),
                roof.add_point({walk - 0.4, eaves - 0.02, -walk + 0.4}));
  scene.add_open("roof", painted(on_all_sides(roof), Paint::roof_tile));
}

void add_garden(MadeScene& scene) {
  const auto a = steps({-garden + 0.15, -0.9, 0.9, garden - 0.15}, 0.6);
  auto ground = panel({0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 0.0, -1.0}, a, a);
  ground = painted(ground, Paint::grass);
  ground = painted(ground, Paint::paving_3, [](const Vec3d& p, const Vec3d&) {
    return std::abs(p.x) < 0.9 || std::abs(p.z) < 0.9 || (std::abs(p.x) < 2.3 && std::abs(p.z) < 2.3);
  });
  scene.add_open("ground", ground);
  scene.add_closed("fountain", moved(fountain(), {0.0, 0.001, 0.0}));
  auto hedges = Mesh{};
  auto balls = Mesh{};
  auto k = 0u;
  for (const auto x : {-1.0, 1.0}) {
    for (const auto z : {-1.0, 1.0}) {
      append(hedges, moved(hedge(2.6, 0.36, 0.48, ++k), {x * 3.85, 0.002, z * 1.28}));
      append(hedges, moved(turned_y(hedge(2.6, 0.36, 0.48, ++k), 90.0), {x * 1.28, 0.002, z * 3.85}));
      append(balls, moved(box_ball(0.42, ++k), {x * 2.52, 0.003, z * 2.52}));
      append(balls, moved(box_ball(0.34, ++k), {x * 5.45, 0.003, z * 1.28}));
      append(balls, moved(box_ball(0.34, ++k), {x * 1.28, 0.003, z * 5.45}));
    }
  }
  scene.add_closed("hedges", hedges);
  scene.add_closed("shrubs", balls);
  auto i = 0u;
  for (const auto& at : {Vec3d(-4.2, 0.002, -4.2), Vec3d(4.3, 0.002, -3.9)}) {
    const auto name = std::to_string(++i);
    scene.add_closed("tree_wood_" + name, moved(tree_wood(4.6, 10 + i), at));
    scene.add_open("tree_leaves_" + name, moved(tree_leaves(4.6, 10 + i, 880), at));
  }
  scene.add_closed("bench_1", placed(garden_bench(), {3.6, 0.002, 2.2}, 180.0));
  scene.add_closed("planter_1", moved(planter(0.6), {-garden + 1.7, floor_height + 0.002, garden + 0.8}));
}

}  // namespace

MadeScene courtyard() {
  auto scene = MadeScene{.title = "A cloister with a fountain, under sun and sky", .sky = "7,11,19"};
  add_arcades(scene);
  add_walks(scene);
  add_building(scene);
  add_garden(scene);
  scene.lights = {{PunctualLight::sun, "sun", {}, {0.60, -0.85, -0.42}, 75'000.0, {1.0, 0.92, 0.80}}};
  scene.views = {{"from the walk", {-3.6, 1.75, 6.2}, {1.3, 2.45, -6.0}, 60.0},
                 {"along the walk", {-8.2, 1.7, 8.4}, {-7.6, 1.75, -6.0}, 60.0}};
  return scene;
}

}  // namespace luxel::scenes
