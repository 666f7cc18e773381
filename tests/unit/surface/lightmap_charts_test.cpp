// SPDX-License-Identifier: Apache-2.0
// Which sides lie together on a chart, and charts on pages.
#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "luxel/core/error.h"
#include "luxel/patch/side.h"
#include "luxel/surface/make_charts.h"
#include "luxel/surface/pack_charts.h"

#include "support/chart_checks.h"
#include "support/lightmap_scenes.h"

namespace luxel {
namespace {

using test::add_box;
using test::add_room;
using test::charts_of;
using test::even_light;
using test::expect_every_front_once;
using test::expect_no_overlap;

// Changes the light of fronts at some places.
template <typename IsThere>
void darken(const PatchSet& patches, Solution& light, const IsThere& is_there, float value) {
  const auto bands = patches.band_count();
  for (std::size_t p = 0; p < patches.size(); ++p)
    if (is_there(patches.centroid(p)))
      for (std::size_t b = 0; b < bands; ++b) light.irradiance.front[p * bands + b] = value;
}

// The charts that have fronts of this material.
std::set<std::uint32_t> charts_on(const PatchSet& patches, const Charts& charts,
                                  const std::string& material) {
  std::set<std::uint32_t> found;
  for (std::size_t p = 0; p < patches.size(); ++p)
    if (patches.material_of(p).name == material) found.insert(charts.of_side[2 * p]);
  return found;
}

TEST(LightmapCharts, a_room_is_a_rectangle_for_each_wall) {
  const auto patches = make_patches(truth::cube({}, 3.0f), {.max_edge = 0.4f});
  const auto charts = charts_of(patches, 0.1f);
  ASSERT_EQ(charts.charts.size(), 6u);
  for (const auto& chart : charts.charts) {
    EXPECT_NEAR(chart.size[0], 3.0, 1e-5);
    EXPECT_NEAR(chart.size[1], 3.0, 1e-5);
  }
  expect_every_front_once(patches, charts);
  expect_no_overlap(patches, charts);
}

TEST(LightmapCharts, a_turned_rectangle_lies_straight_in_its_box) {
  truth::SceneBuilder b;
  b.material("plate", 0.5f, 0.0f).quad({0, 0, 0}, {4, 3, 0}, {2.5f, 5, 0}, {-1.5f, 2, 0});
  const auto patches = make_patches(b.scene(), {.max_edge = 0.5f});
  const auto charts = charts_of(patches, 0.1f);
  ASSERT_EQ(charts.charts.size(), 1u);
  EXPECT_NEAR(charts.charts[0].size[0], 5.0, 1e-5);
  EXPECT_NEAR(charts.charts[0].size[1], 2.5, 1e-5);
}

TEST(LightmapCharts, a_tower_is_a_few_charts_that_each_see_no_steep_side) {
  const auto patches = make_patches(test::tower(48, 2.0f), {.max_edge = 0.5f});
  const auto charts = charts_of(patches, 0.05f);
  EXPECT_GE(charts.charts.size(), 4u);
  EXPECT_LE(charts.charts.size(), 6u);
  expect_every_front_once(patches, charts);
  expect_no_overlap(patches, charts);
  for (const auto& chart : charts.charts)
    for (const auto side : chart.sides)
      EXPECT_GT(glm::dot(glm::cross(chart.axes[0], chart.axes[1]), Vec3d(patches.normal[side.patch()])), 0.7);
}

TEST(LightmapCharts, a_ramp_above_itself_is_not_one_chart) {
  const auto patches = make_patches(test::ramp(36), {.max_edge = 1.0f});
  const auto charts = charts_of(patches, 0.1f);
  EXPECT_GE(charts.charts.size(), 2u);
  EXPECT_LE(charts.charts.size(), 8u);
  expect_every_front_once(patches, charts);
  expect_no_overlap(patches, charts);
}

TEST(LightmapCharts, backs_are_laid_out_where_light_fell_and_then_all_of_their_piece) {
  truth::SceneBuilder b;
  b.material("one", 0.5f, 0.0f).quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
  b.material("other", 0.5f, 0.0f).quad({0, 0, 2}, {1, 0, 2}, {1, 1, 2}, {0, 1, 2});
  const auto patches = make_patches(b.scene(), {.max_edge = 0.3f});
  auto light = even_light(patches, 1.0f);
  light.irradiance.back[0] = 1.0f;
  const auto charts = make_charts(patches, light, {.texel = 0.1f}, Context(1));
  EXPECT_EQ(charts.charts.size(), 3u);
  for (std::size_t p = 0; p < patches.size(); ++p)
    EXPECT_EQ(charts.of_side[2 * p + 1] != none, patches.material_of(p).name == "one");
}

// It is invisible, so it needs neither a separate chart nor a cut of the floor's triangles.
TEST(LightmapCharts, the_floor_under_a_small_box_is_on_the_chart_of_the_floor) {
  truth::SceneBuilder b;
  add_room(b, {0, 0, 0}, {4, 4, 3}, 0.5f);
  b.material("box", 0.5f, 0.0f);
  add_box(b, {1.13f, 1.27f, 0}, {2.21f, 2.4f, 1});
  const auto patches = make_patches(b.scene(), {.max_edge = 0.5f});
  auto light = even_light(patches, 1.0f);
  darken(
      patches, light,
      [](const Vec3& at) {
        return at.z < 0.001f && at.x > 1.13f && at.x < 2.21f && at.y > 1.27f && at.y < 2.4f;
      },
      0.0f);
  const auto charts = make_charts(patches, light, {.texel = 0.1f}, Context(2));
  EXPECT_EQ(charts_on(patches, charts, "floor").size(), 1u);
  expect_no_overlap(patches, charts);
  expect_every_front_once(patches, charts);
}

// The gap's far side belongs to a long triangle whose middle lies on the near one, as all others do.
TEST(LightmapCharts, a_thin_gap_whose_line_parts_nothing_is_cut_elsewhere) {
  const Vec3 foot(0, 0, 0), head(0, 1, 0), left(-1, 0.5f, 0), tip(0.15f, 0.37f, 0), far(-4, 18.4f, 0);
  truth::SceneBuilder b;
  b.material("sheet", 0.5f, 0.0f);
  b.triangle(foot, head, left).triangle(head, far, left).triangle(head, tip, far);
  b.triangle(tip, {1, 10, 0}, far);
  const auto patches = make_patches(b.scene(), {.max_edge = 0.0f});
  ASSERT_EQ(patches.size(), 4u);
  EXPECT_EQ(charts_of(patches, 0.1f).charts.size(), 1u);  // evenly lit: nothing would bleed
  auto light = even_light(patches, 1.0f);
  for (auto value = 2 * patches.band_count(); value < 4 * patches.band_count(); ++value)
    light.irradiance.front[value] = 0.25f;
  const auto charts = make_charts(patches, light, {.texel = 0.08f}, Context(2));
  EXPECT_EQ(charts.charts.size(), 2u);
  EXPECT_NE(charts.of_side[0], charts.of_side[6]);
  expect_every_front_once(patches, charts);
}

// No side of the wall's one face shares a chart with one of the other's.
TEST(LightmapCharts, a_thin_wall_with_a_door_parts_the_floor_along_its_line) {
  for (const float thickness : {0.0f, 0.02f, 0.15f}) {
    truth::SceneBuilder b;
    add_room(b, {0, 0, 0}, {4, 4, 3}, 0.5f);
    b.material("wall", 0.5f, 0.0f);
    if (thickness == 0.0f)
      b.quad({2, 1, 0}, {2, 4, 0}, {2, 4, 3}, {2, 1, 3});
    else
      add_box(b, {2.0f, 1.0f, 0}, {2.0f + thickness, 4, 3});
    const auto patches = make_patches(b.scene(), {.max_edge = 0.5f});
    auto light = even_light(patches, 1.0f);
    darken(
        patches, light, [](const Vec3& at) { return at.x > 2.0f; }, 0.2f);
    if (thickness > 0.0f)
      darken(
          patches, light,
          [&](const Vec3& at) {
            return at.z < 0.001f && at.y > 1.0f && at.x > 2.0f && at.x < 2.0f + thickness;
          },
          0.0f);
    const auto charts = make_charts(patches, light, {.texel = 0.1f}, Context(2));
    std::set<std::uint32_t> before, behind;
    for (std::size_t p = 0; p < patches.size(); ++p) {
      const auto middle = patches.centroid(p);
      if (patches.material_of(p).name != "floor" || middle.y < 1.6f) continue;
      if (middle.x < 2.0f) before.insert(charts.of_side[2 * p]);
      if (middle.x > 2.0f + thickness) behind.insert(charts.of_side[2 * p]);
    }
    for (const auto chart : before) EXPECT_FALSE(behind.contains(chart)) << thickness;
    EXPECT_LE(charts_on(patches, charts, "floor").size(), 4u) << thickness;
  }
}

TEST(LightmapCharts, a_gap_as_wide_as_three_texels_parts_nothing) {
  truth::SceneBuilder b;
  add_room(b, {0, 0, 0}, {4, 4, 3}, 0.5f);
  b.material("wall", 0.5f, 0.0f);
  add_box(b, {2.0f, 1.0f, 0}, {2.3f, 3.5f, 3});
  const auto patches = make_patches(b.scene(), {.max_edge = 0.5f});
  EXPECT_EQ(charts_on(patches, charts_of(patches, 0.1f), "floor").size(), 1u);
}

TEST(LightmapCharts, what_is_larger_than_a_page_is_cut) {
  const auto patches = make_patches(truth::cube({}, 3.0f), {.max_edge = 0.4f});
  const auto charts = charts_of(patches, 0.1f, 0.0f, 12);
  for (const auto& chart : charts.charts) EXPECT_LE(std::max(chart.size[0], chart.size[1]), 1.2 + 1e-6);
  expect_every_front_once(patches, charts);
  EXPECT_THROW(charts_of(patches, 0.1f, 0.0f, 2), InputError);
}

TEST(LightmapCharts, the_same_on_any_number_of_threads) {
  const auto patches = make_patches(test::tower(48, 2.0f), {.max_edge = 0.3f});
  const auto light = even_light(patches, 1.0f);
  const auto one = make_charts(patches, light, {}, Context(1)),
             five = make_charts(patches, light, {}, Context(5));
  EXPECT_EQ(one.of_side, five.of_side);
  EXPECT_EQ(pack_charts(patches, one, {}).corners, pack_charts(patches, five, {}).corners);
}

TEST(LightmapCharts, light_of_other_patches_and_senseless_options_are_refused) {
  const auto patches = make_patches(truth::cube({}), {.max_edge = 0.5f});
  EXPECT_THROW(make_charts(patches, {}, {}, Context(1)), MismatchError);
  const auto light = even_light(patches, 1.0f);
  EXPECT_THROW(make_charts(patches, light, {.texel = 0.0f}, Context(1)), InputError);
  EXPECT_THROW(make_charts(patches, light, {.max_angle = 80.0f}, Context(1)), InputError);
  const auto charts = make_charts(patches, light, {}, Context(1));
  EXPECT_THROW(pack_charts(patches, charts, {.page_size = 4}), InputError);
  EXPECT_THROW(pack_charts(patches, charts, {.page_size = 16, .margin = 8}), InputError);
  EXPECT_THROW(pack_charts(patches, charts, {.texel = 0.001f, .page_size = 64}), InputError);
  EXPECT_THROW(pack_charts(patches, charts, {.texel = 1e-4f, .page_size = 16384}), InputError);
}

}  // namespace
}  // namespace luxel
