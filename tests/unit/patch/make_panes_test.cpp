// SPDX-License-Identifier: Apache-2.0
// Which triangles of glass are panes, and which faces belong to one body.
#include "luxel/patch/make_panes.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "luxel/patch/make_patches.h"
#include "luxel/patch/refine_patches.h"

#include "support/glass_panes.h"

namespace luxel {
namespace {

using truth::SceneBuilder;

Scene glass(SceneBuilder& builder, const Vec3& transmittance = Vec3(0.8f)) {
  auto scene = builder.scene();
  truth::make_pane(scene, "glass", transmittance);
  return scene;
}

bool all_are(const std::vector<GlassTriangle>& found, GlassBody body) {
  return std::all_of(found.begin(), found.end(), [&](const GlassTriangle& t) { return t.body == body; });
}

TEST(MakePanes, a_single_surface_counts_at_each_crossing) {
  SceneBuilder builder;
  builder.material("glass", 0.1f, 0.0f).quad({0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1});
  const auto panes = make_panes(glass(builder));
  ASSERT_EQ(panes.size(), 2u);
  for (const auto& pane : panes) {
    EXPECT_EQ(pane.exponent, 1.0f);
    EXPECT_EQ(glm::abs(pane.axis), Vec3(0, 1, 0));
    EXPECT_EQ(pane.material, MaterialId{0});
  }
}

TEST(MakePanes, the_faces_of_a_thin_box_share_its_transmittance_and_its_axis) {
  SceneBuilder builder;
  builder.material("glass", 0.1f, 0.0f);
  truth::add_box(builder, {0, 0, 0}, {1, 0.006f, 1});
  const auto scene = glass(builder);
  EXPECT_TRUE(all_are(find_glass(scene), GlassBody::thin_body));
  const auto panes = make_panes(scene);
  ASSERT_EQ(panes.size(), 12u);
  for (const auto& pane : panes) {
    EXPECT_EQ(pane.exponent, 0.5f);
    EXPECT_EQ(glm::abs(pane.axis), Vec3(0, 1, 0));
  }
}

TEST(MakePanes, a_box_without_its_narrow_sides_but_one_is_a_box) {
  SceneBuilder builder;
  builder.material("glass", 0.1f, 0.0f)
      .quad({0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1})
      .quad({0, 0.006f, 0}, {0, 0.006f, 1}, {1, 0.006f, 1}, {1, 0.006f, 0})
      .quad({0, 0, 0}, {0, 0.006f, 0}, {1, 0.006f, 0}, {1, 0, 0});
  EXPECT_TRUE(all_are(find_glass(glass(builder)), GlassBody::thin_body));
}

TEST(MakePanes, two_sheets_that_do_not_lie_over_each_other_are_no_box) {
  SceneBuilder builder;
  builder.material("glass", 0.1f, 0.0f)
      .quad({0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1})
      .quad({0, 0.006f, 1}, {1, 0.006f, 1}, {1, 0.006f, 2}, {0, 0.006f, 2})
      .quad({0, 0, 1}, {0, 0.006f, 1}, {1, 0.006f, 1}, {1, 0, 1});
  EXPECT_TRUE(all_are(find_glass(glass(builder)), GlassBody::sheet));
}

TEST(MakePanes, two_sheets_that_do_not_touch_count_twice) {
  SceneBuilder builder;
  builder.material("glass", 0.1f, 0.0f)
      .quad({0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1})
      .quad({0, 0.016f, 0}, {1, 0.016f, 0}, {1, 0.016f, 1}, {0, 0.016f, 1});
  EXPECT_TRUE(all_are(find_glass(glass(builder)), GlassBody::sheet));
}

TEST(MakePanes, a_thick_body_shares_its_transmittance_at_the_angles_of_its_faces) {
  SceneBuilder builder;
  builder.material("glass", 0.1f, 0.0f);
  truth::add_box(builder, {0, 0, 0}, {1, 1, 1});
  for (const auto& pane : make_panes(glass(builder))) {
    EXPECT_EQ(pane.exponent, 0.5f);
    const auto n = glm::cross(pane.corner[1] - pane.corner[0], pane.corner[2] - pane.corner[0]);
    EXPECT_NEAR(std::fabs(glm::dot(pane.axis, glm::normalize(n))), 1.0, 1e-6);
  }
}

TEST(MakePanes, the_same_triangle_twice_is_one_sheet) {
  SceneBuilder builder;
  builder.material("glass", 0.1f, 0.0f)
      .triangle({0, 0, 0}, {1, 0, 0}, {1, 0, 1})
      .triangle({1, 0, 1}, {1, 0, 0}, {0, 0, 0});
  const auto panes = make_panes(glass(builder));
  ASSERT_EQ(panes.size(), 1u);
  EXPECT_EQ(panes[0].exponent, 1.0f);
}

TEST(MakePanes, two_faces_in_one_place_with_other_diagonals_count_once_together) {
  SceneBuilder builder;
  builder.material("glass", 0.1f, 0.0f)
      .triangle({0, 0, 0}, {1, 0, 0}, {1, 0, 1})
      .triangle({0, 0, 0}, {1, 0, 1}, {0, 0, 1})
      .triangle({1, 0, 0}, {0, 0, 0}, {0, 0, 1})
      .triangle({1, 0, 0}, {0, 0, 1}, {1, 0, 1});
  const auto panes = make_panes(glass(builder));
  ASSERT_EQ(panes.size(), 4u);
  for (const auto& pane : panes) EXPECT_EQ(pane.exponent, 0.5f);
}

TEST(MakePanes, glass_that_lets_all_light_pass_is_no_pane_and_no_patch) {
  auto builder = truth::window_room();
  builder.material("glass", 0.1f, 0.0f);
  truth::add_sheet(builder);
  EXPECT_TRUE(make_panes(glass(builder, Vec3(1.0f))).empty());
  EXPECT_EQ(find_glass(glass(builder, Vec3(1.0f))).size(), 2u);
  const auto patches = make_patches(glass(builder, Vec3(1.0f)), {.max_edge = 1.0f});
  EXPECT_TRUE(patches.panes.empty());
  EXPECT_EQ(patches.size(), make_patches(truth::window_room().scene(), {.max_edge = 1.0f}).size());
}

TEST(MakePanes, patches_keep_the_panes_and_their_transmittance_by_band) {
  auto builder = truth::window_room();
  builder.material("glass", 0.1f, 0.0f);
  truth::add_sheet(builder);
  const auto patches = make_patches(glass(builder, Vec3(0.5f, 0.75f, 1.0f)), {.max_edge = 1.0f});
  ASSERT_EQ(patches.panes.size(), 2u);
  const auto& material = patches.materials[static_cast<std::size_t>(patches.panes[0].material)];
  EXPECT_EQ(material.name, "glass");
  EXPECT_EQ(material.transmittance, (std::vector<float>{0.5f, 0.75f, 1.0f}));
  const std::vector<std::uint8_t> marked(patches.size(), 1);
  EXPECT_EQ(refine_patches(patches, marked, Context(1)).patches.panes, patches.panes);
}

TEST(MakePanes, the_fingerprint_knows_the_transmittance) {
  SceneBuilder builder;
  builder.material("glass", 0.1f, 0.0f).quad({0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1});
  EXPECT_NE(fingerprint(glass(builder, Vec3(0.8f))), fingerprint(glass(builder, Vec3(0.7f))));
  EXPECT_NE(fingerprint(glass(builder, Vec3(0.8f))), fingerprint(glass(builder, Vec3(1.0f))));
}

}  // namespace
}  // namespace luxel
