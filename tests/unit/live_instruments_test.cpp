// SPDX-License-Identifier: Apache-2.0
// What a window reads off a mesh and its light, held against light written down by hand.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "luxel/live/patch_levels.h"
#include "luxel/live/probe.h"
#include "luxel/live/tree_boxes.h"

#include "support/lit_patches.h"

namespace luxel {
namespace {

// A floor of 2 x 1 m in z = 0, front up: two triangles to the left, lit with 4 W/m² a band from above, and
// two to the right with 2; an error of 0.5 W/m² a band.
LiveLight floor_light() {
  test::LitPatches lit({test::plain_material("floor", 0.25f)});
  for (const auto& p :
       {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(0, 1, 0), Vec3(1, 1, 0), Vec3(2, 1, 0)})
    lit.vertex(p);
  lit.patch({0, 1, 4}, 4.0f, 1.0f);
  lit.patch({0, 4, 3}, 4.0f, 1.0f);
  lit.patch({1, 2, 5}, 2.0f);
  lit.patch({1, 5, 4}, 2.0f);
  lit.patches.triangle = {7, 7, 8, 9};
  lit.patches.origin = Vec3d(100.0, 0.0, 0.0);
  lit.solution.standard_error_front.assign(12, 0.5f);
  lit.solution.standard_error_back.assign(12, 0.25f);
  LiveLight light;
  light.mesh.geometry = 1;
  light.mesh.patches = std::make_shared<const PatchSet>(lit.patches);
  light.mesh.tracer = std::make_shared<const Tracer>(lit.patches, Workers(1));
  light.smooth = std::make_shared<const SmoothLight>(
      make_smooth_light(lit.patches, lit.solution, {.crease_angle = 0.0f}));
  light.solution = std::move(lit.solution);
  return light;
}

Ray down(float x, float y) { return {{x, y, 3.0f}, {0.0f, 0.0f, -1.0f}}; }

TEST(LiveInstruments, a_probe_reads_the_patch_it_meets) {
  const auto light = floor_light();
  const auto found = probe(light.mesh, &light, down(0.75f, 0.25f));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->patch, 0u);
  EXPECT_FALSE(found->back);
  EXPECT_FLOAT_EQ(found->distance, 3.0f);
  EXPECT_NEAR(found->at.x, 100.75, 1e-6);
  EXPECT_EQ(found->normal, Vec3(0, 0, 1));
  EXPECT_DOUBLE_EQ(found->area, 0.5);
  EXPECT_NEAR(found->longest_edge, std::sqrt(2.0), 1e-6);
  EXPECT_EQ(found->material, "floor");
  EXPECT_EQ(found->triangle, 7u);
  EXPECT_DOUBLE_EQ(found->irradiance->watts, 12.0);
  EXPECT_NEAR(found->irradiance->lux, 4.0 * 179.0, 1e-9);
  EXPECT_DOUBLE_EQ(found->irradiance->watts_error.value(), 1.5);
  EXPECT_NEAR(found->irradiance->lux_error.value(), 0.5 * 179.0, 1e-9);
  EXPECT_DOUBLE_EQ(found->radiosity->watts, 3.0);
  EXPECT_DOUBLE_EQ(found->radiosity->watts_error.value(), 0.375);
  EXPECT_NEAR(found->smooth_irradiance->watts, 12.0, 1e-5);
}

TEST(LiveInstruments, a_probe_from_below_reads_the_back) {
  const auto light = floor_light();
  const auto found = probe(light.mesh, &light, {{0.75f, 0.25f, -1.0f}, {0.0f, 0.0f, 1.0f}});
  ASSERT_TRUE(found && found->back);
  EXPECT_EQ(found->normal, Vec3(0, 0, -1));
  EXPECT_DOUBLE_EQ(found->irradiance->watts, 3.0);
  EXPECT_DOUBLE_EQ(found->irradiance->watts_error.value(), 0.75);
}

TEST(LiveInstruments, a_probe_knows_the_surface_before_there_is_light_and_nothing_beside_it) {
  const auto light = floor_light();
  const auto found = probe(light.mesh, nullptr, down(0.5f, 0.25f));
  ASSERT_TRUE(found);
  EXPECT_FALSE(found->irradiance);
  EXPECT_FALSE(probe(light.mesh, &light, down(5.0f, 0.5f)));
  auto mesh = light.mesh;
  mesh.tracer.reset();
  EXPECT_FALSE(probe(mesh, &light, down(0.5f, 0.25f)));
}

TEST(LiveInstruments, a_profile_follows_the_light_along_a_line) {
  const auto light = floor_light();
  std::vector<Ray> rays;
  for (int i = 0; i < 5; ++i) rays.push_back(down(0.15f + 0.45f * static_cast<float>(i), 0.4f));
  rays.push_back(down(3.0f, 0.4f));
  const auto points = profile(light.mesh, &light, rays);
  ASSERT_EQ(points.size(), 6u);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_NEAR(points[i].along, 0.45 * static_cast<double>(i), 1e-6);
    EXPECT_NEAR(points[i].irradiance.watts, i < 2 ? 12.0 : 6.0, 1e-5) << i;
    EXPECT_DOUBLE_EQ(points[i].irradiance.watts_error.value(), 1.5);
  }
  EXPECT_FALSE(points[5].is_lit);
}

TEST(LiveInstruments, levels_count_the_halvings_of_a_triangle) {
  const auto light = floor_light();
  EXPECT_EQ(patch_levels(*light.mesh.patches), (std::vector<std::uint8_t>{1, 1, 0, 0}));
  for (const auto size : patch_sizes(*light.mesh.patches)) EXPECT_FLOAT_EQ(size, std::sqrt(2.0f));
}

TEST(LiveInstruments, boxes_of_each_level_hold_their_children_and_the_first_holds_all) {
  // A row of 64 squares.
  test::LitPatches lit;
  for (std::uint32_t i = 0; i <= 64; ++i)
    for (const float y : {0.0f, 1.0f}) lit.vertex({static_cast<float>(i), y, 0.0f});
  for (std::uint32_t i = 0; i < 64; ++i) {
    lit.patch({2 * i, 2 * i + 2, 2 * i + 3}, 1.0f);
    lit.patch({2 * i, 2 * i + 3, 2 * i + 1}, 1.0f);
  }
  const auto tree = make_patch_tree(lit.patches, Workers(1));
  const auto levels = tree_boxes(lit.patches, tree);
  ASSERT_GT(levels.size(), 4u);
  ASSERT_EQ(levels[0].size(), 1u);
  EXPECT_EQ(levels[0][0].low, Vec3(0, 0, 0));
  EXPECT_EQ(levels[0][0].high, Vec3(64, 1, 0));
  for (std::size_t k = 1; k < levels.size(); ++k)
    for (const auto& box : levels[k]) {
      const auto holds = [&](const Bounds& parent) {
        return parent.low.x <= box.low.x && box.high.x <= parent.high.x;
      };
      EXPECT_TRUE(std::any_of(levels[k - 1].begin(), levels[k - 1].end(), holds)) << "level " << k;
    }
}

}  // namespace
}  // namespace luxel
