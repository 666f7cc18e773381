// SPDX-License-Identifier: Apache-2.0
// Data that a window reads from a mesh and its light, compared with light written by hand.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "luxel/lamps/direct_light.h"
#include "luxel/patch/make_patches.h"
#include "luxel/patch/patch_tree.h"
#include "luxel/patch/side.h"
#include "luxel/session/patch_levels.h"
#include "luxel/session/probe.h"
#include "luxel/session/sample_rays.h"
#include "luxel/session/tree_boxes.h"
#include "luxel/solution/sample_state.h"

#include "support/lit_patches.h"
#include "support/truth_scenes.h"

namespace luxel {
namespace {

// A floor of 2 x 1 m in z = 0, front up: two triangles to the left, lit with 4 W/m² a band from above, and
// two to the right with 2; an error of 0.5 W/m² a band.
SessionLight floor_light() {
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
  lit.solution.standard_error.front.assign(12, 0.5f);
  lit.solution.standard_error.back.assign(12, 0.25f);
  SessionLight light;
  light.mesh.geometry = 1;
  light.mesh.patches = std::make_shared<const PatchSet>(lit.patches);
  light.mesh.tracer = std::make_shared<const Tracer>(lit.patches, Context(1));
  light.smooth = std::make_shared<const SmoothLight>(
      make_smooth_light(lit.patches, lit.solution, {.crease_angle = 0.0f}));
  light.solution = std::move(lit.solution);
  return light;
}

Ray down(float x, float y) { return {{x, y, 3.0f}, {0.0f, 0.0f, -1.0f}}; }

TEST(Overlays, a_probe_reads_the_patch_it_meets) {
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

TEST(Overlays, a_probe_from_below_reads_the_back) {
  const auto light = floor_light();
  const auto found = probe(light.mesh, &light, {{0.75f, 0.25f, -1.0f}, {0.0f, 0.0f, 1.0f}});
  ASSERT_TRUE(found && found->back);
  EXPECT_EQ(found->normal, Vec3(0, 0, -1));
  EXPECT_DOUBLE_EQ(found->irradiance->watts, 3.0);
  EXPECT_DOUBLE_EQ(found->irradiance->watts_error.value(), 0.75);
}

TEST(Overlays, a_probe_knows_the_surface_before_there_is_light_and_nothing_beside_it) {
  const auto light = floor_light();
  const auto found = probe(light.mesh, nullptr, down(0.5f, 0.25f));
  ASSERT_TRUE(found);
  EXPECT_FALSE(found->irradiance);
  EXPECT_FALSE(probe(light.mesh, &light, down(5.0f, 0.5f)));
  auto mesh = light.mesh;
  mesh.tracer.reset();
  EXPECT_FALSE(probe(mesh, &light, down(0.5f, 0.25f)));
}

TEST(Overlays, a_profile_follows_the_light_along_a_line) {
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

TEST(Overlays, levels_count_the_halvings_of_a_triangle) {
  const auto light = floor_light();
  EXPECT_EQ(patch_levels(*light.mesh.patches), (std::vector<std::uint8_t>{1, 1, 0, 0}));
  for (const auto size : patch_sizes(*light.mesh.patches)) EXPECT_FLOAT_EQ(size, std::sqrt(2.0f));
}

TEST(Overlays, boxes_of_each_level_hold_their_children_and_the_first_holds_all) {
  // A row of 64 squares.
  test::LitPatches lit;
  for (std::uint32_t i = 0; i <= 64; ++i)
    for (const float y : {0.0f, 1.0f}) lit.vertex({static_cast<float>(i), y, 0.0f});
  for (std::uint32_t i = 0; i < 64; ++i) {
    lit.patch({2 * i, 2 * i + 2, 2 * i + 3}, 1.0f);
    lit.patch({2 * i, 2 * i + 3, 2 * i + 1}, 1.0f);
  }
  const auto tree = make_patch_tree(lit.patches, Context(1));
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

SessionMesh mesh_of(const PatchSet& patches) {
  const Context context(1);
  SessionMesh mesh;
  mesh.patches = std::make_shared<const PatchSet>(patches);
  mesh.tracer = std::make_shared<const Tracer>(patches, context);
  mesh.tree = std::make_shared<const PatchTree>(make_patch_tree(patches, context));
  mesh.geometry = 1;
  return mesh;
}

TEST(Overlays, rays_of_a_patch_are_those_of_the_solver) {
  SessionLight light;
  light.mesh = mesh_of(make_patches(truth::furnace(Vec3(0.5f), Vec3(0.2f)), {.max_edge = 0.5f}));
  light.sampled.error = 0.001;
  SolveHooks storage;
  storage.keep = [&](auto state) { light.samples = state; };
  solve_sampled(*light.mesh.patches, *light.mesh.tracer, light.solution, light.sampled, storage, Context(1));
  const auto& samples = *light.samples;
  ASSERT_GT(samples.rounds.size(), 1u);

  for (std::uint32_t receiver = 0; receiver < samples.sides.size(); receiver += 7) {
    const auto side = samples.sides[receiver];
    const auto rays = gather_rays(light, side.patch(), side.is_back(), 1u << 20);
    std::size_t next = 0;
    for (const auto& round : samples.rounds) {
      const auto at = std::find(round.receivers.begin(), round.receivers.end(), receiver);
      if (at == round.receivers.end()) continue;
      const auto place = static_cast<std::size_t>(at - round.receivers.begin());
      for (std::uint32_t r = 0; r < samples.replicates; ++r)
        for (std::uint32_t k = 0; k < round.per_replicate; ++k, ++next) {
          ASSERT_LT(next, rays.size());
          EXPECT_EQ(rays[next].replicate, r);
          const auto element = round.hits[r * round.hits_per_replicate() + place * round.per_replicate + k];
          ASSERT_LT(element, samples.sides.size()) << "a furnace is closed, and every side is lit";
          EXPECT_EQ(rays[next].hit.side(), samples.sides[element]);
        }
    }
    EXPECT_EQ(next, rays.size());
    EXPECT_EQ(gather_rays(light, side.patch(), side.is_back(), 10).size(), 10u);
  }
}

// A floor of 1 m, a lamp as large 2 m above it, and between them a board over its half.
PatchSet shaded_floor() {
  test::LitPatches lit(
      {test::plain_material("grey", 0.5f, false), test::plain_material("lamp", 0.0f, false, 1.0f)});
  const auto square = [&](float x1, float z, std::uint32_t material, bool down) {
    const auto a = lit.vertex({0, 0, z});
    const auto b = lit.vertex({x1, 0, z});
    const auto c = lit.vertex({x1, 1, z});
    const auto d = lit.vertex({0, 1, z});
    lit.patch(down ? std::array{a, c, b} : std::array{a, b, c}, 0.0f, 0.0f, material);
    lit.patch(down ? std::array{a, d, c} : std::array{a, c, d}, 0.0f, 0.0f, material);
  };
  square(1.0f, 0.0f, 0, false);
  square(0.5f, 1.0f, 0, false);
  square(1.0f, 2.0f, 1, true);
  return lit.patches;
}

TEST(Overlays, shadow_rays_are_blocked_where_the_board_is) {
  SessionLight light;
  light.mesh = mesh_of(shaded_floor());
  const auto rays = direct_rays(light, 0, false);
  ASSERT_EQ(rays.size(), 256u);
  std::size_t seen = 0;
  for (const auto& ray : rays) {
    EXPECT_NEAR(ray.from.z, 0.0f, 1e-4f);
    EXPECT_NEAR(ray.to.z, 2.0f, 1e-4f);
    const auto x = 0.5f * (ray.from.x + ray.to.x);  // half way up
    if (std::abs(x - 0.5f) > 1e-3f) {
      EXPECT_EQ(ray.seen, x > 0.5f);
    }
    seen += ray.seen ? 1 : 0;
  }
  EXPECT_GT(seen, 32u);
  EXPECT_LT(seen, 224u);
  EXPECT_TRUE(direct_rays(light, 0, true).empty()) << "a one-sided back gathers nothing";
  EXPECT_TRUE(direct_rays(light, 4, false).empty()) << "the lamp sees no lamp";
}

TEST(Overlays, shadow_rays_add_up_to_the_estimate_they_were_taken_for) {
  const auto patches = shaded_floor();
  const auto mesh = mesh_of(patches);
  const Lamps lamps(patches);
  for (const bool cosine_rays : {false, true}) {
    const DirectLight direct(patches, *mesh.tracer, lamps,
                             {.replicates = 4, .control_variate = false, .multiple_importance = cosine_rays});
    std::vector<float> estimate(4 * 3);
    direct.estimate(SideId(0, false), 0, 0, 64, estimate);
    std::vector<double> sum(4, 0.0);
    for (const auto& ray : direct.rays_of(SideId(0, false), 0, 0, 64))
      if (ray.seen) sum[ray.replicate] += ray.given * static_cast<double>(lamps.radiance(ray.lamp)[0]) / 64.0;
    for (std::size_t r = 0; r < 4; ++r) EXPECT_NEAR(estimate[3 * r], sum[r], 1e-6) << "replicate " << r;
  }
}

}  // namespace
}  // namespace luxel
