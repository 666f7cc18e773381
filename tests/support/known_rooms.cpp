// SPDX-License-Identifier: Apache-2.0
#include "support/known_rooms.h"

#include "luxel/patch/make_patches.h"

#include "support/truth_scenes.h"

namespace luxel::truth {
namespace {

KnownRoom with_truth(const std::string& name, const Scene& scene, float max_edge,
                     const std::vector<ConvexPolygon>& screens = {}) {
  KnownRoom room;
  room.name = name;
  room.patches = make_patches(scene, {.max_edge = max_edge});
  const Context context;
  room.truth = true_light(room.patches, form_factors(room.patches, screens, context));
  room.truth_error = screens.empty() ? 1e-6 : 1e-5;
  return room;
}

// A quarter by a quarter of the unit cube's ceiling, facing down.
void ceiling_tile(SceneBuilder& b, int i, int j) {
  const auto x = static_cast<float>(i) / 4.0f;
  const auto y = static_cast<float>(j) / 4.0f;
  constexpr float w = 0.25f;
  b.quad({x, y + w, 1}, {x + w, y + w, 1}, {x + w, y, 1}, {x, y, 1});
}

// The unit cube whose ceiling is sixteen tiles, lamps where `is_lamp(i, j)` names a material.
struct Tile {
  int i, j;
  Vec3 emittance;
};
SceneBuilder tiled_cube(const std::vector<Tile>& lamps, const Vec3& left, const Vec3& right) {
  SceneBuilder b;
  b.material("floor", 0.3f, 0.0f).quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
  b.material("left", left, Vec3(0.0f)).quad({0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1});
  b.material("right", right, Vec3(0.0f)).quad({1, 0, 1}, {1, 1, 1}, {1, 1, 0}, {1, 0, 0});
  b.material("ends", 0.5f, 0.0f);
  b.quad({0, 0, 1}, {1, 0, 1}, {1, 0, 0}, {0, 0, 0}).quad({0, 1, 0}, {1, 1, 0}, {1, 1, 1}, {0, 1, 1});
  for (std::size_t k = 0; k < lamps.size(); ++k) {
    b.material("lamp " + std::to_string(k), Vec3(0.2f), lamps[k].emittance);
    ceiling_tile(b, lamps[k].i, lamps[k].j);
  }
  b.material("ceiling", 0.7f, 0.0f);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      bool lamp = false;
      for (const auto& tile : lamps) lamp = lamp || (tile.i == i && tile.j == j);
      if (!lamp) ceiling_tile(b, i, j);
    }
  return b;
}

constexpr float plate_low = 0.25f, plate_high = 0.75f, plate_z = 0.5f;
const std::array<Vec3, 4> plate = {{{plate_low, plate_low, plate_z},
                                    {plate_high, plate_low, plate_z},
                                    {plate_high, plate_high, plate_z},
                                    {plate_low, plate_high, plate_z}}};

}  // namespace

KnownRoom luminous_ceiling() { return with_truth("luminous_ceiling", cube_a(), 0.26f); }

KnownRoom open_plates() { return with_truth("open_plates", plates(), 0.18f); }

KnownRoom mixed_furnace() {
  std::array<Wall, 6> walls;
  const std::array<float, 6> reflectance = {0.2f, 0.8f, 0.5f, 0.3f, 0.65f, 0.1f};
  for (std::size_t k = 0; k < 6; ++k) walls[k] = {reflectance[k], 1.0f - reflectance[k]};
  const auto shell = cube(walls);
  auto scene = furnace(Vec3(0.5f), Vec3(0.4f));  // its walls come first, two triangles each, as the cube's do
  const auto block = scene.materials[1];
  scene.materials = shell.materials;
  scene.materials.push_back(block);
  for (std::size_t t = 0; t < scene.triangles.size(); ++t)
    scene.triangle_material[t] =
        t < shell.triangles.size() ? shell.triangle_material[t] : MaterialId(shell.materials.size());

  KnownRoom room;
  room.name = "mixed_furnace";
  room.patches = make_patches(scene, {.max_edge = 0.26f});
  room.truth_error = 1e-6;  // emittances are floats
  room.truth.irradiance.front.assign(room.patches.size() * room.patches.band_count(), 1.0);
  room.truth.irradiance.back.assign(room.truth.irradiance.front.size(), 0.0);
  return room;
}

KnownRoom coloured_room() {
  const auto b = tiled_cube({{1, 1, {20.0f, 4.0f, 0.5f}}, {3, 2, {0.5f, 6.0f, 25.0f}}}, {0.7f, 0.2f, 0.1f},
                            {0.1f, 0.2f, 0.6f});
  return with_truth("coloured_room", b.scene(), 0.26f);
}

namespace {

Scene hung_plate_scene() {
  auto b = tiled_cube({{1, 1, Vec3(10.0f)}}, Vec3(0.5f), Vec3(0.5f));
  b.material("plate", 0.4f, 0.0f).quad(plate[0], plate[1], plate[2], plate[3]);
  return b.scene();
}

}  // namespace

KnownRoom hung_plate() { return with_truth("hung_plate", hung_plate_scene(), 0.26f, hung_plate_screens()); }

KnownRoom opal_plate() {
  auto scene = hung_plate_scene();
  scene.materials.back().diffuse_transmittance = Vec3(0.4f);
  return with_truth("opal_plate", scene, 0.26f, hung_plate_screens());
}

KnownRoom l_shaped() { return with_truth("l_shaped", l_room(), 0.36f, l_room_screens()); }

const std::vector<RoomMaker>& known_rooms() {
  static const std::vector<RoomMaker> rooms = {
      {"luminous_ceiling", luminous_ceiling}, {"open_plates", open_plates}, {"mixed_furnace", mixed_furnace},
      {"coloured_room", coloured_room},       {"hung_plate", hung_plate},   {"l_shaped", l_shaped}};
  return rooms;
}

std::vector<ConvexPolygon> hung_plate_screens() { return {convex_polygon(plate)}; }

std::vector<ConvexPolygon> l_room_screens() {
  const std::array<Vec3, 4> inner_y1 = {{{1, 1, 0}, {2, 1, 0}, {2, 1, 1}, {1, 1, 1}}};
  const std::array<Vec3, 4> inner_x1 = {{{1, 1, 1}, {1, 2, 1}, {1, 2, 0}, {1, 1, 0}}};
  return {convex_polygon(inner_y1), convex_polygon(inner_x1)};
}

}  // namespace luxel::truth
