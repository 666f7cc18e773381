// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <gtest/gtest.h>

#include "luxel/patch/make_patches.h"

#include "support/truth_scenes.h"

namespace luxel {
namespace {

using truth::SceneBuilder;

// A board of 1 m x 0.7 m, 2 cm thick, whose underside is `gap` above a floor of 4 m x 4 m.
Scene board_above_floor(float gap) {
  SceneBuilder scene;
  scene.material("floor", 0.5f, 0.0f).quad({0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0});
  const Vec3 a(1.31f, 1.13f, gap), b(2.31f, 1.83f, gap + 0.02f);
  const auto at = [&](bool x, bool y, bool z) { return Vec3(x ? b.x : a.x, y ? b.y : a.y, z ? b.z : a.z); };
  scene.material("board", 0.5f, 0.0f)
      .quad(at(0, 0, 0), at(0, 1, 0), at(1, 1, 0), at(1, 0, 0))
      .quad(at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1))
      .quad(at(0, 0, 0), at(1, 0, 0), at(1, 0, 1), at(0, 0, 1))
      .quad(at(1, 0, 0), at(1, 1, 0), at(1, 1, 1), at(1, 0, 1))
      .quad(at(1, 1, 0), at(0, 1, 0), at(0, 1, 1), at(1, 1, 1))
      .quad(at(0, 1, 0), at(0, 0, 0), at(0, 0, 1), at(0, 1, 1));
  return scene.scene();
}

// Areas of the floor, m²: hidden by the board as seen from above, and in patches that lie half below it.
struct FloorAreas {
  double hidden = 0.0, crossed = 0.0;
};

FloorAreas floor_areas(const PatchSet& patches) {
  FloorAreas areas;
  for (std::size_t p = 0; p < patches.size(); ++p) {
    if (static_cast<std::uint32_t>(patches.material[p]) != 0) continue;
    int inside = 0, outside = 0;
    for (const auto& corner : patches.points(p)) {
      const double x = std::min(static_cast<double>(corner.x) - 1.31, 2.31 - static_cast<double>(corner.x));
      const double y = std::min(static_cast<double>(corner.y) - 1.13, 1.83 - static_cast<double>(corner.y));
      inside += std::min(x, y) > 1e-5 ? 1 : 0;
      outside += std::min(x, y) < -1e-5 ? 1 : 0;
    }
    if (inside > 0 && outside > 0) areas.crossed += static_cast<double>(patches.area[p]);
    if (outside == 0) areas.hidden += static_cast<double>(patches.area[p]);
  }
  return areas;
}

std::size_t floor_contacts(const PatchSet& patches) {
  return static_cast<std::size_t>(
      std::count_if(patches.contacts.begin(), patches.contacts.end(),
                    [&](const Contact& c) { return patches.vertices[c.edge[0]].z == 0.0f; }));
}

constexpr float max_edge = 0.1f;  // lines are found up to 3.5 cm

TEST(NearLines, the_floor_is_cut_along_the_outline_of_a_board_close_above_it) {
  for (const float gap : {0.001f, 0.01f, 0.03f}) {
    const auto areas = floor_areas(make_patches(board_above_floor(gap), {.max_edge = max_edge}));
    EXPECT_NEAR(areas.hidden, 0.7, 1e-5) << gap;
    EXPECT_EQ(areas.crossed, 0.0) << gap;
  }
}

TEST(NearLines, patches_themselves_resolve_the_shadow_of_a_wider_gap) {
  const auto patches = make_patches(board_above_floor(0.05f), {.max_edge = max_edge});
  EXPECT_EQ(floor_contacts(patches), 0u);
  EXPECT_GT(floor_areas(patches).crossed, 0.0);
}

// The board's own faces are 2 cm apart, and the floor lies 1 cm behind its underside.
// The plate has no face along the floor: its foot alone divides the light.
TEST(NearLines, the_floor_is_cut_along_the_foot_of_a_plate_that_does_not_quite_touch_it) {
  const auto crossing = [](float gap) {
    SceneBuilder scene;
    scene.material("floor", 0.5f, 0.0f).quad({0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0});
    scene.material("plate", 0.5f, 0.0f).quad({1, 1.53f, gap}, {3, 1.53f, gap}, {3, 1.53f, 1}, {1, 1.53f, 1});
    const auto patches = make_patches(scene.scene(), {.max_edge = max_edge});
    std::size_t count = 0;
    for (std::size_t p = 0; p < patches.size(); ++p) {
      if (static_cast<std::uint32_t>(patches.material[p]) != 0) continue;
      const auto& points = patches.points(p);
      const auto [low, high] = std::minmax({points[0].y, points[1].y, points[2].y});
      const auto centre = patches.centroid(p);
      if (centre.x > 1.1 && centre.x < 2.9 && low < 1.53f - 1e-4f && high > 1.53f + 1e-4f) ++count;
    }
    return count;
  };
  EXPECT_EQ(crossing(0.005f), 0u);
  EXPECT_GT(crossing(0.02f), 0u) << "light passes below it: its shadow is as soft as the gap is wide";
}

// A sheet of 0.8 m x 0.8 m in cells of 4 cm x 10 cm, and a disc of 10 cm radius and 32 edges of 2 cm before
// it.
Scene disc_before_sheet(float gap) {
  constexpr int columns = 20, rows = 8;
  SceneBuilder scene;
  scene.material("wall", 0.5f, 0.0f).quad({-5, -5, -3}, {5, -5, -3}, {5, 5, -3}, {-5, 5, -3});
  scene.material("sheet", 0.5f, 0.0f);
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < rows; ++j) {
      const auto at = [&](int x, int y) {
        return Vec3(0.04f * static_cast<float>(i + x), 0.1f * static_cast<float>(j + y), 0);
      };
      scene.quad(at(0, 0), at(1, 0), at(1, 1), at(0, 1));
    }
  scene.material("disc", 0.5f, 0.0f);
  const auto at = [&](int i) {
    const auto angle = 2.0 * std::numbers::pi * (i % 32) / 32.0;
    return Vec3(0.413f + 0.1f * static_cast<float>(std::cos(angle)),
                0.387f + 0.1f * static_cast<float>(std::sin(angle)), gap);
  };
  for (int i = 0; i < 32; i += 2) scene.quad({0.413f, 0.387f, gap}, at(i), at(i + 1), at(i + 2));
  return scene.scene();
}

double contact_length(const PatchSet& patches) {
  double length = 0.0;
  for (const auto& contact : patches.contacts)
    length +=
        glm::distance(Vec3d(patches.vertices[contact.edge[0]]), Vec3d(patches.vertices[contact.edge[1]]));
  return length;
}

// Its triangles are narrower than the third of an edge up to which wide ones are cut, 10.5 cm. An outline
// with an opening would let the darkness behind the disc spread from there.
TEST(NearLines, a_sheet_of_small_triangles_is_cut_along_the_whole_outline_of_a_disc_that_is_glued_on_it) {
  const auto patches = make_patches(disc_before_sheet(0.002f), {.max_edge = 0.3f});
  EXPECT_NEAR(contact_length(patches), 64.0 * 0.1 * std::sin(std::numbers::pi / 32.0), 1e-3);
}

TEST(NearLines, small_triangles_themselves_resolve_the_shadow_of_a_gap_of_a_tenth_of_their_height) {
  EXPECT_EQ(contact_length(make_patches(disc_before_sheet(0.006f), {.max_edge = 0.3f})), 0.0);
}

TEST(NearLines, a_surface_is_not_cut_by_what_lies_behind_it) {
  auto scene = board_above_floor(0.01f);
  for (auto& corners : scene.triangles)
    if (static_cast<std::uint32_t>(
            scene.triangle_material[static_cast<std::size_t>(&corners - scene.triangles.data())]) == 0)
      std::swap(corners[1], corners[2]);
  EXPECT_EQ(floor_contacts(make_patches(scene, {.max_edge = max_edge})), 0u);
}

TEST(NearLines, light_may_jump_at_the_outline_on_the_side_of_the_board) {
  const auto patches = make_patches(board_above_floor(0.01f), {.max_edge = max_edge});
  double length = 0.0;
  for (const auto& contact : patches.contacts) {
    if (patches.vertices[contact.edge[0]].z > 0.0f) continue;  // on the board
    EXPECT_NEAR(contact.into.z, 1.0f, 1e-6f);
    length +=
        glm::distance(Vec3d(patches.vertices[contact.edge[0]]), Vec3d(patches.vertices[contact.edge[1]]));
  }
  EXPECT_NEAR(length, 2.0 * (1.0 + 0.7), 1e-5);
}

}  // namespace
}  // namespace luxel
