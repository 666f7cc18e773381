// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/refine_to_light.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "luxel/core/address.h"
#include "luxel/core/bounds.h"
#include "luxel/patch/make_patches.h"
#include "luxel/solve/mesh_estimate.h"
#include "luxel/trace/tracer.h"

#include "support/truth_scenes.h"
#include "support/window_rooms.h"

namespace luxel {
namespace {

constexpr float lamp_size = 0.1f;
constexpr float lamp_height = 1.0f;

// A square black floor of 2 m, a small lamp 1 m above its middle, and between them a plate with a corner over
// the middle: a shadow with two long edges. Everything is black, so all light is direct.
Scene shadowed_floor() {
  truth::SceneBuilder b;
  const float h = 0.5f * lamp_size;
  b.material("floor", 0.0f, 0.0f).quad({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0});
  b.material("lamp", 0.0f, 100.0f)
      .quad({-h, -h, lamp_height}, {-h, h, lamp_height}, {h, h, lamp_height}, {h, -h, lamp_height});
  b.material("plate", 0.0f, 0.0f)
      .quad({0.05f, 0.02f, 0.4f}, {0.6f, 0.02f, 0.4f}, {0.6f, 0.6f, 0.4f}, {0.05f, 0.6f, 0.4f});
  return b.scene();
}

// Irradiance of the floor's front at a place, by a fine grid on the lamp.
double irradiance_at(const Vec3& place, const Tracer& tracer) {
  constexpr int n = 24;
  double sum = 0.0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const Vec3 on_lamp(lamp_size * ((static_cast<float>(i) + 0.5f) / n - 0.5f),
                         lamp_size * ((static_cast<float>(j) + 0.5f) / n - 0.5f), lamp_height);
      const auto way = on_lamp - place;
      const auto distance = glm::length(way);
      const auto cosine = way.z / distance;
      if (tracer.occluded({place + Vec3(0, 0, 1e-5f), way / distance}, 0.999f * distance)) continue;
      sum += static_cast<double>(cosine * cosine / (distance * distance));
    }
  return 100.0 / 3.14159265358979 * static_cast<double>(lamp_size * lamp_size) / (n * n) * sum;
}

// Area-weighted relative RMS of the light reconstructed on the floor against the truth, by random places.
double true_error(const PatchSet& patches, const Tracer& tracer, const Context& context) {
  Solution solution;
  solve_sampled(patches, tracer, solution, {.error = 0.002, .error_measure = ErrorMeasure::power}, context);
  const auto smooth = make_smooth_light(patches, solution, {}, context);
  double squared_error = 0.0;
  double squared_light = 0.0;
  for (std::uint32_t p = 0; p < patches.size(); ++p) {
    if (patches.material_of(p).name != "floor") continue;
    constexpr int places = 4;
    for (std::uint32_t k = 0; k < places; ++k) {
      auto u = uniform4({.seed = 5, .step = k, .element = p, .sample = 0});
      if (u[0] + u[1] > 1.0f) u = {1.0f - u[0], 1.0f - u[1], 0.0f, 0.0f};
      const auto q = patches.points(p);
      const auto truth = irradiance_at((1.0f - u[0] - u[1]) * q[0] + u[0] * q[1] + u[1] * q[2], tracer);
      const auto& c = smooth.corners[p];
      const auto at = [&](std::size_t i) { return static_cast<double>(smooth.irradiance.front[3 * c[i]]); };
      const auto found = (1.0 - static_cast<double>(u[0] + u[1])) * at(0) +
                         static_cast<double>(u[0]) * at(1) + static_cast<double>(u[1]) * at(2);
      const auto weight = static_cast<double>(patches.area[p]) / places;
      squared_error += weight * (found - truth) * (found - truth);
      squared_light += weight * truth * truth;
    }
  }
  return std::sqrt(squared_error / squared_light);
}

TEST(RefineToLight, patches_gather_at_a_shadows_edge_until_the_error_is_met) {
  const Context context(2);
  const auto scene = shadowed_floor();
  RefineReport report;
  const auto patches =
      refine_to_light(make_patches(scene, {.max_edge = 0.3f}),
                      {.mesh_error = 0.02, .light = {.error_measure = ErrorMeasure::power}}, report, context);
  EXPECT_EQ(report.stop, RefineStop::mesh_error_reached);
  EXPECT_LE(report.mesh_error, 0.02);
  const Tracer tracer(patches, context);
  const auto error = true_error(patches, tracer, context);
  // The stated error bounds the true one where light jumps, and exceeds it where light is smooth.
  EXPECT_LE(error, 1.15 * report.mesh_error);
  EXPECT_GE(error, 0.4 * report.mesh_error);

  // So does that of light solved on these patches.
  std::array<Solution, 2> halves;
  Solution solution;
  solve_sampled(patches, tracer, solution, {.error = 0.01, .error_measure = ErrorMeasure::power, .seed = 7},
                {.halves = &halves}, context);
  const auto by_light = mesh_error_of(patches, tracer, halves, ErrorMeasure::power, {}, context);
  EXPECT_LE(error, 1.15 * by_light);
  EXPECT_GE(error, 0.4 * by_light);

  // More patches of one size do worse.
  float edge = 0.3f;
  PatchSet uniform;
  do {
    edge *= 0.7f;
    uniform = make_patches(scene, {.max_edge = edge});
  } while (uniform.size() <= patches.size());
  const Tracer through(uniform, context);
  EXPECT_GT(true_error(uniform, through, context), 1.2 * error);
}

TEST(RefineToLight, light_that_is_the_same_everywhere_needs_no_more_patches) {
  const Context context(2);
  const auto patches = make_patches(truth::furnace(Vec3(0.5f), Vec3(0.5f)), {.max_edge = 0.25f});
  RefineReport report;
  const auto refined = refine_to_light(patches, {.mesh_error = 0.01}, report, context);
  EXPECT_NE(report.stop, RefineStop::patch_limit);
  EXPECT_LE(report.mesh_error, 0.01);
  EXPECT_LE(report.levels.size(), 2u);
}

TEST(RefineToLight, it_never_makes_more_patches_than_allowed) {
  const Context context(2);
  RefineReport report;
  const auto patches = refine_to_light(make_patches(shadowed_floor(), {.max_edge = 0.3f}),
                                       {.mesh_error = 0.001, .max_patches = 700}, report, context);
  EXPECT_LE(patches.size(), 700u);
  EXPECT_EQ(report.stop, RefineStop::patch_limit);
}

TEST(RefineToLight, beyond_the_usual_patches_it_goes_on_while_that_pays) {
  const Context context(2);
  constexpr std::size_t usual = 400;
  const auto report_of = [&](float edge, std::size_t usual_patches) {
    RefineReport report;
    refine_to_light(make_patches(shadowed_floor(), {.max_edge = edge}),
                    {.mesh_error = 0.005,
                     .usual_patches = usual_patches,
                     .light = {.error_measure = ErrorMeasure::power}},
                    report, context);
    return report;
  };
  // Around a shadow in large patches the first levels halve the error.
  const auto coarse = report_of(0.3f, usual);
  EXPECT_GT(coarse.levels.back().patches, usual + usual / 2);
  // In small ones none does.
  const auto fine = report_of(0.1f, usual);
  EXPECT_EQ(fine.stop, RefineStop::patch_limit);
  const auto unlimited = report_of(0.1f, 1'000'000);
  EXPECT_EQ(unlimited.stop, RefineStop::mesh_error_reached);
  EXPECT_LT(fine.levels.back().patches, unlimited.levels.back().patches);
}

TEST(RefineToLight, its_progress_moves_from_the_first_light_on_and_never_back) {
  double now = 0.0, of_first_light = 0.0;
  const auto context = Context(2).with_monitor([&](const Progress& p) {
    EXPECT_GE(p.done, now);
    EXPECT_LE(p.done, 1.0);
    now = p.done;
    if (p.error == 0.0) of_first_light = p.done;
    return Next::go_on;
  });
  RefineReport report;
  refine_to_light(make_patches(shadowed_floor(), {.max_edge = 0.3f}),
                  {.mesh_error = 0.001, .max_cost = 1.0, .free_rays = 4'000'000}, report, context);
  EXPECT_GT(of_first_light, 0.3);
  EXPECT_GT(now, of_first_light);
}

TEST(RefineToLight, it_begins_no_level_beyond_the_cost_allowed) {
  RefineReport report;
  const auto patches = refine_to_light(make_patches(shadowed_floor(), {.max_edge = 0.3f}),
                                       {.mesh_error = 0.001, .max_cost = 1e-6, .free_rays = 0}, report);
  EXPECT_EQ(report.stop, RefineStop::cost_limit);
  // One mesh with light, and one whose error is a prediction.
  ASSERT_EQ(report.levels.size(), 2u);
  EXPECT_GT(report.levels[0].rays, 0u);
  EXPECT_EQ(report.levels[1].rays, 0u);
  EXPECT_GT(report.levels[1].patches, report.levels[0].patches);
  EXPECT_LT(report.levels[1].mesh_error, report.levels[0].mesh_error);
  EXPECT_EQ(report.levels[1].patches, patches.size());
  EXPECT_EQ(report.mesh_error, report.levels[1].mesh_error);
}

// A pavilion of 4 m under an even sky: floor, roof, eight posts and two rails.
Scene pavilion() {
  truth::SceneBuilder b;
  b.material("floor", 0.5f, 0.0f);
  truth::add_box(b, {-2, -2, -0.2f}, {2, 2, 0});
  for (const auto y : {-1.9f, 1.8f}) truth::add_box(b, {-1.9f, y, 0.9f}, {1.9f, y + 0.1f, 1});
  b.material("wood", 0.15f, 0.0f);
  truth::add_box(b, {-2, -2, 2.5f}, {2, 2, 2.6f});
  for (const auto x : {-1.9f, -0.6f, 0.6f, 1.8f})
    for (const auto y : {-1.9f, 1.8f}) truth::add_box(b, {x, y, 0}, {x + 0.1f, y + 0.1f, 2.5f});
  auto scene = b.scene();
  scene.sky = Vec3(1.0f);
  return scene;
}

// A room of 1 m with two blocks and a lamp below the ceiling.
Scene room_with_blocks() {
  truth::SceneBuilder b;
  b.material("wall", 0.7f, 0.0f);
  truth::add_box(b, {0, 0, 0}, {1, 1, 1});
  b.material("block", 0.6f, 0.0f);
  truth::add_box(b, {0.15f, 0.55f, 0}, {0.45f, 0.85f, 0.6f});
  truth::add_box(b, {0.55f, 0.15f, 0}, {0.85f, 0.45f, 0.3f});
  b.material("lamp", 0.0f, 20.0f);
  truth::add_box(b, {0.4f, 0.4f, 0.96f}, {0.6f, 0.6f, 0.98f});
  return b.scene();
}

// The error that ends the refinement, from the rough light that decided about the cuts, against that of light
// solved well on the same mesh: high after cuts, where it allows for their selection.
TEST(RefineToLight, states_the_error_of_the_mesh_where_the_cost_has_a_bound) {
  const Context context(2);
  for (const auto& scene : {pavilion(), room_with_blocks()}) {
    RefineReport report;
    const auto patches = refine_to_light(make_patches(scene, {.target_count = RefineOptions::coarse_patches}),
                                         {.mesh_error = 0.02, .max_cost = 0.5}, report, context);
    EXPECT_EQ(report.stop, RefineStop::mesh_error_reached);
    std::array<Solution, 2> halves;
    Solution solution;
    const Tracer tracer(patches, context);
    solve_sampled(patches, tracer, solution, {.error = 0.01, .seed = 7}, {.halves = &halves}, context);
    const auto found = mesh_error_of(patches, tracer, halves, ErrorMeasure::seen, {}, context);
    EXPECT_GT(report.mesh_error, found / 1.5);
    EXPECT_LT(report.mesh_error, 3.0 * found);
  }
}

// A black plate far below has nearly all the area; the views are in the room.
TEST(RefineToLight, walls_are_cut_before_the_first_light_by_what_the_views_see_of_them) {
  auto b = truth::SceneBuilder();
  b.material("plate", 0.0f, 0.0f).quad({-50, -50, -5}, {50, -50, -5}, {50, 50, -5}, {-50, 50, -5});
  b.material("wall", 0.5f, 0.5f)
      .quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0})
      .quad({0, 0, 1}, {0, 1, 1}, {1, 1, 1}, {1, 0, 1})
      .quad({0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0})
      .quad({0, 1, 0}, {1, 1, 0}, {1, 1, 1}, {0, 1, 1})
      .quad({0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1})
      .quad({1, 0, 0}, {1, 0, 1}, {1, 1, 1}, {1, 1, 0});
  const auto longest_of_walls = [&](ErrorMeasure measure) {
    RefineReport report;
    const auto patches =
        refine_to_light(make_patches(b.scene(), {.max_edge = no_max_edge}),
                        {.mesh_error = 0.9, .max_levels = 1, .light = {.error_measure = measure}}, report);
    float longest = 0.0f;
    for (std::size_t p = 0; p < patches.size(); ++p)
      for (std::size_t k = 0; k < 3 && patches.material_of(p).name == "wall"; ++k)
        longest = std::max(longest, glm::distance(patches.points(p)[k], patches.points(p)[(k + 1) % 3]));
    return longest;
  };
  // An equilateral triangle on the edge is at most a thousandth of what is seen: 6 m², or half of the 12 m²
  // where the outside is a place too.
  EXPECT_LT(longest_of_walls(ErrorMeasure::seen), 0.2f);
  EXPECT_GT(longest_of_walls(ErrorMeasure::power), 0.9f);
}

// A plate of 3 cm, 1 cm above a floor of patches 13 times as long, below a lamp as large as the floor.
// Without its shadow the error would be 1.5 %.
TEST(RefineToLight, a_shadow_smaller_than_its_patch_is_cut_out) {
  truth::SceneBuilder b;
  const Vec3 middle(0.3f, -0.2f, 0.01f);
  const float h = 0.015f;
  b.material("floor", 0.5f, 0.0f).quad({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0});
  b.material("lamp", 0.0f, 10.0f).quad({-1, -1, 1}, {-1, 1, 1}, {1, 1, 1}, {1, -1, 1});
  b.material("plate", 0.0f, 0.0f)
      .quad(middle + Vec3(-h, -h, 0), middle + Vec3(h, -h, 0), middle + Vec3(h, h, 0),
            middle + Vec3(-h, h, 0));
  RefineReport report;
  const auto patches = refine_to_light(
      make_patches(b.scene(), {.max_edge = 0.4f, .contacts = false}),
      {.mesh_error = 0.005, .max_cost = 0.5, .light = {.error_measure = ErrorMeasure::power}}, report);
  float longest = 0.0f;  // of the patches that touch the plate's footprint
  for (std::size_t p = 0; p < patches.size(); ++p) {
    if (patches.material_of(p).name != "floor") continue;
    Bounds box;
    for (const auto& corner : patches.points(p)) box.add(corner);
    if (box.low.x > middle.x + h || box.high.x < middle.x - h || box.low.y > middle.y + h ||
        box.high.y < middle.y - h)
      continue;
    longest = std::max(longest, std::max(box.size().x, box.size().y));
  }
  EXPECT_LT(longest, 0.05f);
}

TEST(RefineToLight, the_same_patches_on_any_number_of_threads) {
  const auto base = make_patches(shadowed_floor(), {.max_edge = 0.3f});
  const RefineOptions options{.mesh_error = 0.3};
  RefineReport report;
  const auto one = refine_to_light(base, options, report, Context(1));
  const auto three = refine_to_light(base, options, report, Context(3));
  EXPECT_EQ(one.corners, three.corners);
  EXPECT_EQ(one.vertices, three.vertices);
}

}  // namespace
}  // namespace luxel
