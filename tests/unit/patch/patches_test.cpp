// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "luxel/core/error.h"
#include "luxel/patch/make_patches.h"

#include "support/truth_scenes.h"

namespace luxel {
namespace {

double longest_edge(const PatchSet& patches) {
  double longest = 0.0;
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const auto [a, b, c] = patches.points(p);
    longest = std::max({longest, static_cast<double>(glm::distance(a, b)),
                        static_cast<double>(glm::distance(b, c)), static_cast<double>(glm::distance(c, a))});
  }
  return longest;
}

double total_area(const PatchSet& patches) {
  double sum = 0.0;
  for (const auto a : patches.area) sum += a;
  return sum;
}

// Collects warnings.
struct Ear {
  std::vector<std::string> heard;
  Context context() {
    return Context().with_log([this](const Message& m) { heard.push_back(m.text); });
  }
};

TEST(Patches, no_edge_is_longer_than_asked_and_the_area_stays) {
  for (const float edge : {0.7f, 0.21f, 0.05f}) {
    const auto patches = make_patches(truth::l_room(), {.max_edge = edge});
    EXPECT_LE(longest_edge(patches), edge);
    EXPECT_NEAR(total_area(patches), 14.0, 1e-4);  // floor 3, ceiling 3, eight walls
  }
}

// In a closed room every edge is met by exactly two patches, once in each direction: no cracks, no
// T-vertices, although the triangles of the walls meet at edges of different length.
TEST(Patches, a_closed_room_stays_closed_when_it_is_split) {
  for (const float edge : {0.33f, 0.1f, 0.03f}) {
    const auto patches = make_patches(truth::l_room(), {.max_edge = edge});
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
    for (const auto& c : patches.corners)
      for (std::size_t k = 0; k < 3; ++k) ++uses[{c[k], c[(k + 1) % 3]}];
    for (const auto& [ends, count] : uses) {
      EXPECT_EQ(count, 1);
      EXPECT_EQ(uses.count({ends.second, ends.first}), 1u);
    }
  }
}

TEST(Patches, neighbours_that_share_no_index_but_a_place_are_split_alike) {
  truth::SceneBuilder b;  // the builder gives each triangle vertices of its own
  b.material("m", 0.5f, 1.0f)
      .triangle({0, 0, 0}, {3, 0, 0}, {0, 1, 0})
      .triangle({3, 0, 0}, {0, 0, 0}, {0, -2, 0});
  const auto patches = make_patches(b.scene(), {.max_edge = 0.4f});
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> on_the_border;
  for (const auto& c : patches.corners)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto i = c[k];
      const auto j = c[(k + 1) % 3];
      if (patches.vertices[i].y == 0.0f && patches.vertices[j].y == 0.0f) ++on_the_border[std::minmax(i, j)];
    }
  EXPECT_EQ(on_the_border.size(), 8u);  // 3 m in halves: 0.375 m
  for (const auto& [ends, count] : on_the_border) EXPECT_EQ(count, 2);
}

TEST(Patches, triangles_as_they_come_are_one_patch_each) {
  const auto patches = make_patches(truth::cube_a(), {.max_edge = no_max_edge});
  ASSERT_EQ(patches.size(), 12u);
  EXPECT_EQ(patches.vertices.size(), 8u);
  for (std::uint32_t p = 0; p < 12; ++p) EXPECT_EQ(patches.triangle[p], p);
  EXPECT_EQ(patches.normal[0], Vec3(0, 0, 1));
  EXPECT_FLOAT_EQ(patches.area[0], 0.5f);
  EXPECT_EQ(patches.bands, (std::vector<std::string>{"red", "green", "blue"}));
  EXPECT_EQ(patches.material_of(0).name, "floor");
}

TEST(Patches, the_input_triangle_of_a_patch_counts_dropped_ones_too) {
  truth::SceneBuilder b;
  b.material("m", 0.5f, 1.0f)
      .triangle({0, 0, 0}, {1, 0, 0}, {2, 0, 0})
      .triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  Ear ear;
  const auto patches = make_patches(b.scene(), {.max_edge = no_max_edge}, ear.context());
  ASSERT_EQ(patches.size(), 1u);
  EXPECT_EQ(patches.triangle[0], 1u);
  ASSERT_EQ(ear.heard.size(), 1u);
  EXPECT_NE(ear.heard[0].find("1 of 2 triangles have no area"), std::string::npos) << ear.heard[0];
}

TEST(Patches, of_two_triangles_in_one_place_one_stays_lit_on_both_sides) {
  truth::SceneBuilder b;
  b.material("sheet", 0.5f, 0.0f, false)
      .triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0})
      .triangle({0, 1, 0}, {1, 0, 0}, {0, 0, 0});
  b.material("lamp", 0.0f, 1.0f).triangle({0, 0, 1}, {1, 0, 1}, {0, 1, 1});
  Ear ear;
  const auto patches = make_patches(b.scene(), {.max_edge = no_max_edge}, ear.context());
  ASSERT_EQ(patches.size(), 2u);
  EXPECT_TRUE(patches.material_of(0).two_sided);
  EXPECT_EQ(patches.material_of(0).name, "sheet");
  EXPECT_FALSE(patches.materials[0].two_sided) << "other faces of the material keep their side";
  EXPECT_EQ(ear.heard.size(), 1u);
}

TEST(Patches, a_lamp_that_shares_its_place_with_a_wall_stays) {
  truth::SceneBuilder b;
  b.material("wall", 0.5f, 0.0f).triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  b.material("lamp", 0.0f, 1.0f).triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  const auto patches = make_patches(b.scene(), {.max_edge = no_max_edge});
  ASSERT_EQ(patches.size(), 1u);
  EXPECT_EQ(patches.material_of(0).name, "lamp");
  EXPECT_EQ(patches.triangle[0], 1u);
}

TEST(Patches, a_pane_that_lets_light_through_is_no_patch) {
  auto scene = truth::plates();
  scene.materials[1].opaque = false;
  const auto patches = make_patches(scene, {.max_edge = no_max_edge});
  ASSERT_EQ(patches.size(), 2u);
  EXPECT_EQ(patches.material_of(0).name, "lower");
}

TEST(Patches, the_automatic_edge_makes_about_the_target_at_any_scale) {
  for (const float size : {0.001f, 1.0f, 1000.0f}) {
    const auto patches = make_patches(truth::cube({}, size), {.target_count = 20'000});
    EXPECT_GT(patches.size(), 10'000u);
    EXPECT_LT(patches.size(), 40'000u);
  }
}

TEST(Patches, a_hopeless_edge_is_refused_at_once_with_one_that_fits) {
  try {
    make_patches(truth::cube_a(), {.max_edge = 1e-5f});
    FAIL() << "expected an InputError";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("would fit"), std::string::npos) << error.what();
  }
}

TEST(Patches, a_scene_of_nothing_but_lines_is_refused) {
  truth::SceneBuilder b;
  b.material("m", 0.5f, 1.0f).triangle({0, 0, 0}, {1, 0, 0}, {2, 0, 0});
  EXPECT_THROW(make_patches(b.scene()), InputError);
}

TEST(Patches, an_edge_as_short_as_floats_can_tell_is_left_alone) {
  truth::SceneBuilder b;
  const float x = 1e7f;
  b.material("m", 0.5f, 1.0f).triangle({x, 0, 0}, {x + 1.0f, 0, 0}, {x, 1, 0});
  const auto patches = make_patches(b.scene(), {.max_edge = 0.4f});
  ASSERT_GT(patches.size(), 0u);
  for (const auto area : patches.area) EXPECT_GT(area, 0.0f);
  EXPECT_NEAR(total_area(patches), 0.5, 1e-6);
}

}  // namespace
}  // namespace luxel
