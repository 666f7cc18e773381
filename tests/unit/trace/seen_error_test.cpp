// SPDX-License-Identifier: Apache-2.0
#include "luxel/trace/seen_error.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "luxel/patch/make_patches.h"
#include "luxel/patch/side.h"
#include "luxel/trace/look_around.h"

#include "support/truth_scenes.h"

namespace luxel {
namespace {

// Views of equal weight that see sides 0, 1, 2, ... of a list.
Views views_of(const std::vector<std::vector<std::uint32_t>>& seen, std::uint32_t sides) {
  Views views;
  views.first.push_back(0);
  for (const auto& each : seen) {
    views.seen.insert(views.seen.end(), each.begin(), each.end());
    views.first.push_back(static_cast<std::uint32_t>(views.seen.size()));
    views.eye.push_back(Vec3(0.0f));
    views.weight.push_back(1.0f / static_cast<float>(seen.size()));
  }
  for (std::uint32_t s = 0; s < sides; ++s) views.sides.push_back(SideId::at(s));
  return views;
}

TEST(SeenError, is_the_error_relative_to_the_light_and_a_twentieth_of_what_the_eye_adapts_to) {
  const auto views = views_of({{0, 1, 1, Views::sky}}, 2);
  const SeenLight light{{1.0f, 2.0f}, {0.01f, 0.04f}, 5.0f};
  // a = (1 + 2 + 2 + 5) / 4: nothing is ten times as bright as the median.
  const auto a = 2.5;
  const auto e0 = 0.1 / (1.0 + 0.05 * a);
  const auto e1 = 0.2 / (2.0 + 0.05 * a);
  EXPECT_NEAR(SeenError(views, light).percentile_95(), std::sqrt((e0 * e0 + 2.0 * e1 * e1) / 3.0), 1e-7);
}

TEST(SeenError, a_lamp_dazzles_no_more_than_ten_medians) {
  const auto views = views_of({{0, 0, 0, 1}}, 2);
  const SeenLight light{{1.0f, 1000.0f}, {0.01f, 0.0f}, 0.0f};
  const auto a = (1.0 + 1.0 + 1.0 + 10.0) / 4.0;
  const auto e = 0.1 / (1.0 + 0.05 * a);
  EXPECT_NEAR(SeenError(views, light).percentile_95(), e * std::sqrt(0.75), 1e-7);
}

TEST(SeenError, a_dark_view_is_judged_by_a_tenth_of_the_median_of_views_at_least) {
  const auto views = views_of({{0}, {0}, {1}}, 2);
  const SeenLight light{{1.0f, 0.0f}, {0.0f, 1e-6f}, 0.0f};
  const auto errors = SeenError(views, light);
  EXPECT_NEAR(errors.of_view()[2], 1e-3 / (0.05 * 0.1), 1e-6);
  EXPECT_EQ(errors.of_view()[0], 0.0);
}

// Outer faces of a lit room, at which light leaks through a crack: more than half of what a view from outside
// sees is black.
constexpr std::uint32_t leak = 1, black = 2;
const SeenLight light_of_leaky_room{{1.0f, 0.5f, 0.0f}, {1e-4f, 0.04f, 0.0f}, 0.0f};

TEST(SeenError, views_in_the_dark_do_not_count) {
  const auto views = views_of({{0}, {0}, {leak, black, black}, {leak, black, black}, {black}}, 3);
  const SeenError error(views, light_of_leaky_room);
  EXPECT_NEAR(error.percentile_95(), 0.01 / 1.05, 1e-6);
  const auto attention = error.attention();
  EXPECT_GT(attention[0].weight, 0.0);
  EXPECT_EQ(attention[leak].weight, 0.0);
  EXPECT_EQ(attention[black].weight, 0.0);
}

TEST(SeenError, dark_views_of_cameras_count_and_are_judged_by_the_lit_views) {
  auto views = views_of({{0}, {leak, black, black}, {leak, black, black}, {leak, black, black}}, 3);
  views.cameras = 1;
  // With the other dark views counted, half of the views would adapt to nothing, and e would be 0.2 / 0.5.
  const auto e = 0.2 / (0.5 + 0.05 * 0.1 * 1.0);
  EXPECT_NEAR(SeenError(views, light_of_leaky_room).percentile_95(), e * std::sqrt(1.0 / 3.0), 1e-6);
}

TEST(SeenError, a_view_counts_whose_error_may_hide_light) {
  const auto views = views_of({{0}, {0}, {black}}, 3);
  auto light = light_of_leaky_room;
  light.squared_error[black] = 1e-4f;
  EXPECT_NEAR(SeenError(views, light).percentile_95(), 0.01 / (0.05 * 0.1), 1e-4);
}

TEST(SeenError, surfaces_out_of_focus_adapt_the_eye_and_do_not_count) {
  const auto views = views_of({{0, 1 | Views::unfocused}}, 2);
  const SeenLight light{{1.0f, 3.0f}, {0.01f, 9.0f}, 0.0f};
  EXPECT_NEAR(SeenError(views, light).percentile_95(), 0.1 / (1.0 + 0.05 * 2.0), 1e-7);
}

TEST(SeenError, ninety_five_percent_of_the_views_by_weight_stay_below) {
  auto views = views_of({{0}, {1}, {2}}, 3);
  const SeenLight light{{1.0f, 1.0f, 1.0f}, {1e-4f, 4e-4f, 1e-2f}, 0.0f};
  views.weight = {0.5f, 0.46f, 0.04f};
  EXPECT_NEAR(SeenError(views, light).percentile_95(), 0.02 / 1.05, 1e-6);
  views.weight = {0.5f, 0.4f, 0.1f};
  EXPECT_NEAR(SeenError(views, light).percentile_95(), 0.1 / 1.05, 1e-6);
}

TEST(SeenError, importance_times_squared_errors_adds_up_to_its_square) {
  const auto views = views_of({{0, 1}, {1, 2}, {2, 2}}, 3);
  const SeenLight light{{1.0f, 2.0f, 0.5f}, {1e-4f, 4e-4f, 1e-4f}, 0.0f};
  const SeenError error(views, light);
  const auto attention = error.attention();
  const auto importance = [&](std::size_t s) {
    return attention[s].importance(static_cast<double>(light.radiance[s]));
  };
  double sum = 0.0;
  for (std::size_t s = 0; s < 3; ++s) sum += importance(s) * static_cast<double>(light.squared_error[s]);
  EXPECT_NEAR(std::sqrt(sum), error.percentile_95(), 1e-9);
  EXPECT_GT(importance(2), importance(0)) << "dim, and seen by the worst view";
}

TEST(SeenError, attention_is_what_views_look_at_whatever_its_light) {
  const auto views = views_of({{0, 1, 1, 1}}, 3);
  const SeenLight light{{1.0f, 7.0f, 3.0f}, {1e-4f, 4e-4f, 1e-4f}, 0.0f};
  const auto attention = SeenError(views, light).attention();
  EXPECT_NEAR(attention[1].weight, 3.0 * attention[0].weight, 1e-9 * attention[1].weight);
  const auto a = (1.0 + 3.0 * 7.0) / 4.0;
  EXPECT_NEAR(attention[0].adaptation, 0.05 * a, 1e-9);
  EXPECT_NEAR(attention[1].adaptation, 0.05 * a, 1e-9);
  EXPECT_EQ(attention[2].weight, 0.0) << "no view sees it";
  EXPECT_EQ(attention[2].importance(0.0), 0.0);
}

TEST(SeenError, light_of_a_side_is_radiance_with_its_own_emission) {
  const auto patches = make_patches(truth::cube({truth::Wall{0.5f, 2.0f}}), {.max_edge = no_max_edge});
  const SideEstimate here{{4.0f, 4.0f, 4.0f}, {0.04, 0.04, 0.04}}, far{{9.0f, 9.0f, 9.0f}, {1.0, 1.0, 1.0}};
  const auto front = light_of_side(patches, SideId(0, false), here, far, false);
  EXPECT_NEAR(front.radiance, 4.0 / std::numbers::pi, 1e-6) << "2 emitted and half of 4";
  EXPECT_NEAR(std::sqrt(front.squared_error), 0.1 / std::numbers::pi, 1e-6);
  const auto back = light_of_side(patches, SideId(0, true), here, far, false);
  EXPECT_NEAR(back.radiance, 2.0 / std::numbers::pi, 1e-6);
  const auto as_irradiance = light_of_side(patches, SideId(0, true), here, far, true);
  EXPECT_NEAR(as_irradiance.radiance, 4.0 / std::numbers::pi, 1e-6);
}

TEST(SeenError, light_of_a_diffuser_is_of_both_sides_with_independent_errors) {
  auto scene = truth::cube({truth::Wall{0.5f, 0.0f}});
  scene.materials[0].diffuse_transmittance = Vec3(0.25f);
  const auto patches = make_patches(scene, {.max_edge = no_max_edge});
  const SideEstimate here{{4.0f, 4.0f, 4.0f}, {0.04, 0.04, 0.04}},
      far{{8.0f, 8.0f, 8.0f}, {0.64, 0.64, 0.64}};
  const auto seen = light_of_side(patches, SideId(0, true), here, far, false);
  EXPECT_NEAR(seen.radiance, 4.0 / std::numbers::pi, 1e-6) << "half of 4 and a quarter of 8";
  EXPECT_NEAR(std::sqrt(seen.squared_error), std::hypot(0.1, 0.2) / std::numbers::pi, 1e-6);
}

TEST(LookGrid, directions_are_spread_evenly_over_the_sphere) {
  const LookGrid grid(22);
  auto sum = Vec3(0.0f);
  for (std::size_t cell = 0; cell < grid.cells(); ++cell) {
    const auto d = grid.direction(cell, 0.5f, 0.5f);
    EXPECT_NEAR(glm::length(d), 1.0f, 1e-5f);
    sum += d * d;
  }
  const auto third = static_cast<float>(grid.cells()) / 3.0f;
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(sum[axis] / third, 1.0f, 0.01f);
}

}  // namespace
}  // namespace luxel
