// SPDX-License-Identifier: Apache-2.0
// The values of smooth light: means, weights, exact fields.
#include "luxel/surface/smooth_light.h"

#include <limits>

#include <gtest/gtest.h>

#include "luxel/core/error.h"

#include "support/lit_patches.h"

namespace luxel {
namespace {

using test::LitPatches;
using test::plain_material;

// Squares of side 1 on z = 0, each cut from lower left to upper right; light(x, y) at each patch's middle.
template <typename Light>
LitPatches grid(std::uint32_t n, Light light) {
  LitPatches lit;
  for (std::uint32_t y = 0; y <= n; ++y)
    for (std::uint32_t x = 0; x <= n; ++x)
      lit.vertex(Vec3(static_cast<float>(x), static_cast<float>(y), 0.0f));
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const auto& v = lit.patches.vertices;
    const auto middle = (v[a] + v[b] + v[c]) / 3.0f;
    lit.patch({a, b, c}, light(middle.x, middle.y));
  };
  for (std::uint32_t y = 0; y < n; ++y)
    for (std::uint32_t x = 0; x < n; ++x) {
      const auto a = y * (n + 1) + x;
      add(a, a + 1, a + n + 2);
      add(a, a + n + 2, a + n + 1);
    }
  return lit;
}

TEST(SmoothLight, constant_light_stays_constant) {
  const auto lit = grid(4, [](float, float) { return 0.7f; });
  const auto light = make_smooth_light(lit.patches, lit.solution);
  ASSERT_EQ(light.size(), 25u);
  ASSERT_EQ(light.irradiance.front.size(), 75u);
  for (const auto h : light.irradiance.front) EXPECT_EQ(h, 0.7f);
  for (const auto h : light.irradiance.back) EXPECT_EQ(h, 0.0f);
  for (const auto& n : light.normal) EXPECT_EQ(n, Vec3(0.0f, 0.0f, 1.0f));
}

TEST(SmoothLight, linear_light_is_met_exactly_inside_a_regular_grid) {
  const auto field = [](float x, float y) { return 10.0f + 2.0f * x - 3.0f * y; };
  const auto lit = grid(4, field);
  const auto light = make_smooth_light(lit.patches, lit.solution);
  std::size_t inside = 0;
  for (std::size_t s = 0; s < light.size(); ++s) {
    const auto& p = lit.patches.vertices[light.vertex[s]];
    if (p.x < 0.5f || p.y < 0.5f || p.x > 3.5f || p.y > 3.5f) continue;
    EXPECT_NEAR(light.irradiance.front[3 * s], field(p.x, p.y), 1e-5f);
    ++inside;
  }
  EXPECT_EQ(inside, 9u);
}

TEST(SmoothLight, larger_neighbours_weigh_more) {
  LitPatches lit;
  const auto a = lit.vertex({0, 0, 0}), b = lit.vertex({1, 0, 0}), c = lit.vertex({0, 1, 0}),
             d = lit.vertex({-3, 0, 0});
  lit.patch({a, b, c}, 8.0f);  // 0.5 m²
  lit.patch({a, c, d}, 4.0f);  // 1.5 m²
  const auto light = make_smooth_light(lit.patches, lit.solution);
  ASSERT_EQ(light.size(), 4u);
  const auto at = [&](std::size_t patch, std::size_t corner) {
    return light.irradiance.front[3 * light.corners[patch][corner]];
  };
  EXPECT_EQ(at(0, 0), 5.0f);  // (0.5 * 8 + 1.5 * 4) / 2
  EXPECT_EQ(at(0, 1), 8.0f);
  EXPECT_EQ(at(0, 2), 5.0f);
  EXPECT_EQ(at(1, 2), 4.0f);
  EXPECT_EQ(light.corners[0][0], light.corners[1][0]);
  EXPECT_EQ(light.corners[0][2], light.corners[1][1]);
}

TEST(SmoothLight, each_band_has_its_own_mean) {
  LitPatches lit;
  const auto a = lit.vertex({0, 0, 0}), b = lit.vertex({1, 0, 0}), c = lit.vertex({0, 1, 0}),
             d = lit.vertex({-1, 0, 0});
  lit.patch({a, b, c}, 0.0f);
  lit.patch({a, c, d}, 0.0f);
  lit.solution.irradiance.front = {1, 2, 3, 3, 6, 9};
  lit.solution.irradiance.back = {0, 0, 4, 0, 8, 0};
  const auto light = make_smooth_light(lit.patches, lit.solution);
  const auto s = 3 * light.corners[0][0];
  EXPECT_EQ(light.irradiance.front[s], 2.0f);
  EXPECT_EQ(light.irradiance.front[s + 1], 4.0f);
  EXPECT_EQ(light.irradiance.front[s + 2], 6.0f);
  EXPECT_EQ(light.irradiance.back[s], 0.0f);
  EXPECT_EQ(light.irradiance.back[s + 1], 4.0f);
  EXPECT_EQ(light.irradiance.back[s + 2], 2.0f);
}

TEST(SmoothLight, colour_borders_and_lamps_do_not_cut_the_light) {
  LitPatches lit({plain_material("red", 0.5f), plain_material("lamp", 0.1f, true, 20.0f)});
  const auto a = lit.vertex({0, 0, 0}), b = lit.vertex({1, 0, 0}), c = lit.vertex({0, 1, 0}),
             d = lit.vertex({-1, 0, 0});
  lit.patch({a, b, c}, 2.0f, 0.0f, 0);
  lit.patch({a, c, d}, 4.0f, 0.0f, 1);
  const auto light = make_smooth_light(lit.patches, lit.solution);
  EXPECT_EQ(light.corners[0][0], light.corners[1][0]);
  EXPECT_EQ(light.irradiance.front[3 * light.corners[0][0]], 3.0f);
}

TEST(SmoothLight, a_single_triangle_keeps_its_light) {
  LitPatches lit;
  lit.patch({lit.vertex({0, 0, 0}), lit.vertex({1, 0, 0}), lit.vertex({0, 1, 0})}, 2.0f, 3.0f);
  const auto light = make_smooth_light(lit.patches, lit.solution);
  ASSERT_EQ(light.size(), 3u);
  for (const auto h : light.irradiance.front) EXPECT_EQ(h, 2.0f);
  for (const auto h : light.irradiance.back) EXPECT_EQ(h, 3.0f);
}

TEST(SmoothLight, a_triangle_without_area_gives_numbers) {
  LitPatches lit;
  lit.patch({lit.vertex({0, 0, 0}), lit.vertex({1, 0, 0}), lit.vertex({2, 0, 0})}, 2.0f);
  const auto light = make_smooth_light(lit.patches, lit.solution);
  ASSERT_EQ(light.size(), 3u);
  for (const auto h : light.irradiance.front) EXPECT_EQ(h, 0.0f);
  for (const auto& n : light.normal) EXPECT_EQ(glm::length(n), 1.0f);
}

TEST(SmoothLight, nothing_gives_nothing) {
  const LitPatches lit;
  EXPECT_EQ(make_smooth_light(lit.patches, lit.solution).size(), 0u);
}

TEST(SmoothLight, the_light_of_another_scene_is_refused) {
  auto lit = grid(1, [](float, float) { return 1.0f; });
  lit.solution.irradiance.front.pop_back();
  EXPECT_THROW(make_smooth_light(lit.patches, lit.solution), MismatchError);
  lit.solution.irradiance.front.push_back(1.0f);
  lit.solution.bands = {"a", "b", "c"};
  EXPECT_THROW(make_smooth_light(lit.patches, lit.solution), MismatchError);
}

TEST(SmoothLight, a_senseless_crease_angle_is_refused) {
  const auto lit = grid(1, [](float, float) { return 1.0f; });
  const auto with = [&](float angle) {
    return make_smooth_light(lit.patches, lit.solution, {.crease_angle = angle});
  };
  EXPECT_THROW(with(-1.0f), InputError);
  EXPECT_THROW(with(181.0f), InputError);
  EXPECT_THROW(with(std::numeric_limits<float>::quiet_NaN()), InputError);
}

TEST(SmoothLight, crease_angle_zero_leaves_every_patch_its_own_value) {
  const auto lit = grid(2, [](float x, float y) { return x + 10.0f * y; });
  const auto light = make_smooth_light(lit.patches, lit.solution, {.crease_angle = 0.0f});
  ASSERT_EQ(light.size(), 3 * lit.patches.size());
  for (std::size_t p = 0; p < lit.patches.size(); ++p)
    for (const auto s : light.corners[p])
      EXPECT_EQ(light.irradiance.front[3 * s], lit.solution.irradiance.front[3 * p]);
}

}  // namespace
}  // namespace luxel
