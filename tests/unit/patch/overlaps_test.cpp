// SPDX-License-Identifier: Apache-2.0
#include "luxel/patch/overlaps.h"

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "luxel/patch/make_patches.h"

#include "support/truth_scenes.h"

namespace luxel {
namespace {

using truth::SceneBuilder;

constexpr float patch_edge = 0.5f;  // m

PatchSet patches_of(const SceneBuilder& b) { return make_patches(b.scene(), {.max_edge = patch_edge}); }

// A level rectangle, seen from above or below.
SceneBuilder& level(SceneBuilder& b, const Vec2& low, const Vec2& high, float z = 0.0f, bool down = false) {
  const Vec3 corners[] = {{low.x, low.y, z}, {high.x, low.y, z}, {high.x, high.y, z}, {low.x, high.y, z}};
  return down ? b.quad(corners[0], corners[3], corners[2], corners[1])
              : b.quad(corners[0], corners[1], corners[2], corners[3]);
}

std::map<std::string, double> areas(const PatchSet& patches) {
  std::map<std::string, double> sum;
  for (std::size_t p = 0; p < patches.size(); ++p) sum[patches.material_of(p).name] += patches.area[p];
  return sum;
}

// Expects this much of both to remain, m².
void expect_areas(const PatchSet& patches, double floor, double carpet) {
  auto area = areas(patches);
  EXPECT_NEAR(area["floor"], floor, 1e-5);
  EXPECT_NEAR(area["carpet"], carpet, 1e-5);
}

SceneBuilder floor() {
  SceneBuilder b;
  b.material("floor", 0.5f, 0.0f);
  return level(b, {0, 0}, {4, 4});
}

SceneBuilder floor_with_carpet(const Vec2& low, const Vec2& high, float z = 0.0f, bool down = false) {
  auto b = floor();
  b.material("carpet", 0.25f, 0.0f);
  return level(b, low, high, z, down);
}

TEST(Overlaps, a_carpet_in_the_plane_of_the_floor_covers_it) {
  for (const bool down : {false, true}) {
    auto b = floor_with_carpet({0.7f, 1.3f}, {2.9f, 2.3f}, 0.0f, down);
    expect_areas(patches_of(b), 16.0 - 2.2, 2.2);
  }
}

TEST(Overlaps, it_does_so_whichever_comes_first_in_the_file) {
  SceneBuilder b;
  b.material("carpet", 0.25f, 0.0f);
  level(b, {0.7f, 1.3f}, {2.9f, 2.3f});
  b.material("floor", 0.5f, 0.0f);
  level(b, {0, 0}, {4, 4});
  expect_areas(patches_of(b), 16.0 - 2.2, 2.2);
}

TEST(Overlaps, a_turned_carpet_covers_the_tiles_of_a_floor_though_each_is_smaller) {
  SceneBuilder b;
  b.material("floor", 0.5f, 0.0f);
  const auto halves = {0.0f, 0.5f, 1.0f, 1.5f, 2.0f, 2.5f, 3.0f, 3.5f};
  for (const float x : halves)
    for (const float y : halves) level(b, {x, y}, {x + 0.5f, y + 0.5f});
  b.material("carpet", 0.25f, 0.0f);
  b.quad({2.0f, 0.6f, 0}, {3.4f, 2.0f, 0}, {2.0f, 3.4f, 0}, {0.6f, 2.0f, 0});
  expect_areas(patches_of(b), 16.0 - 3.92, 3.92);
}

TEST(Overlaps, of_two_that_overlap_in_part_each_place_has_one) {
  SceneBuilder b;
  b.material("floor", 0.5f, 0.0f);
  level(b, {0, 0}, {3, 2});
  b.material("carpet", 0.25f, 0.0f);
  level(b, {2, 1}, {4, 2.5f});
  expect_areas(patches_of(b), 6.0 - 1.0, 3.0);
}

TEST(Overlaps, one_material_covers_itself_once) {
  auto b = floor();
  level(b, {1, 1}, {3, 3.5f});
  expect_areas(patches_of(b), 16.0, 0.0);
}

TEST(Overlaps, a_lamp_covers_smaller_surfaces) {
  SceneBuilder b;
  b.material("floor", 0.5f, 1.0f);
  level(b, {0, 0}, {4, 4});
  b.material("carpet", 0.25f, 0.0f);
  level(b, {1, 1}, {2, 2});
  expect_areas(patches_of(b), 16.0, 0.0);
}

TEST(Overlaps, two_lamps_keep_their_power) {
  SceneBuilder b;
  b.material("floor", 0.5f, 1.0f);
  level(b, {0, 0}, {4, 4});
  b.material("carpet", 0.25f, 2.0f);
  level(b, {1, 1}, {2, 2});
  expect_areas(patches_of(b), 16.0, 1.0);
}

TEST(Overlaps, a_carpet_above_the_floor_covers_nothing) {
  for (const float height : {-1e-4f, 1e-4f}) {
    auto b = floor_with_carpet({1, 1}, {2, 2}, height);
    expect_areas(patches_of(b), 16.0, 1.0);
  }
}

TEST(Overlaps, rounding_does_not_lift_a_carpet_off_the_floor) {
  auto b = floor_with_carpet({1, 1}, {2, 2}, 1e-6f);
  expect_areas(patches_of(b), 15.0, 1.0);
}

TEST(Overlaps, one_sided_sheets_back_to_back_are_both_seen) {
  SceneBuilder b;
  b.material("floor", 0.5f, 0.0f, false);
  level(b, {0, 0}, {4, 4});
  b.material("carpet", 0.25f, 0.0f, false);
  level(b, {1, 1}, {2, 2}, 0.0f, true);
  expect_areas(patches_of(b), 16.0, 1.0);
}

TEST(Overlaps, a_one_sided_carpet_leaves_no_hole_in_a_two_sided_floor) {
  auto b = floor();
  b.material("carpet", 0.25f, 0.0f, false);
  level(b, {1, 1}, {2, 2});
  expect_areas(patches_of(b), 16.0, 1.0);
}

TEST(Overlaps, a_carpet_with_holes_covers_nothing) {
  auto b = floor_with_carpet({1, 1}, {2, 2});
  auto scene = b.scene();
  const auto bands = make_patches(scene);
  auto with_holes = bands;
  for (auto& m : with_holes.materials)
    if (m.name == "carpet") m.textures.cutout = TextureUse{};
  VertexWeld weld;
  const auto triangles = clean_triangles(scene, weld).kept;
  EXPECT_FALSE(find_overlaps(triangles, scene.triangle_material, bands.materials, weld.positions(), Context{})
                   .empty());
  EXPECT_TRUE(
      find_overlaps(triangles, scene.triangle_material, with_holes.materials, weld.positions(), Context{})
          .empty());
}

TEST(Overlaps, contacts_are_those_of_the_patches_that_remain) {
  auto b = floor_with_carpet({0.7f, 1.3f}, {2.9f, 2.3f});
  level(b, {1.2f, 1.6f}, {1.7f, 1.9f});  // on the carpet
  const auto patches = patches_of(b);
  expect_areas(patches, 16.0 - 2.2, 2.2);
  std::set<std::array<std::uint32_t, 2>> edges;
  for (const auto& c : patches.corners)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(c[k], c[(k + 1) % 3]);
      edges.insert({low, high});
    }
  EXPECT_FALSE(patches.contacts.empty());
  for (const auto& contact : patches.contacts) EXPECT_TRUE(edges.contains(contact.edge));
}

}  // namespace
}  // namespace luxel
