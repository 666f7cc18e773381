// SPDX-License-Identifier: Apache-2.0
#include "luxel/surface/needle_nodes.h"

#include <cmath>

#include <gtest/gtest.h>

#include "luxel/core/trig.h"
#include "luxel/surface/smooth_light.h"

#include "support/lit_patches.h"

namespace luxel {
namespace {

constexpr float gap = 0.001f;  // m, the width of the needle
constexpr std::size_t needle = 4;

// Two panels of 1 x 1 m with light 1 and 2, and between them a needle with light 1.8. The right panel is
// turned about the joint by some degrees.
test::LitPatches panels(float degrees) {
  test::LitPatches lit;
  const auto dx = std::cos(glm::radians(degrees)), dz = std::sin(glm::radians(degrees));
  const auto a = lit.vertex({0, 0, 0}), b = lit.vertex({1, 0, 0}), c = lit.vertex({1, 1, 0}),
             d = lit.vertex({0, 1, 0}), e = lit.vertex({1 + gap, 1, 0}), f = lit.vertex({1 + dx, 0, dz}),
             g = lit.vertex({1 + gap + dx, 1, dz});
  lit.patch({a, b, c}, 1.0f);
  lit.patch({a, c, d}, 1.0f);
  lit.patch({b, f, g}, 2.0f);
  lit.patch({b, g, e}, 2.0f);
  lit.patch({b, e, c}, 1.8f);
  return lit;
}

float light_at(const SmoothLight& light, std::size_t patch, std::size_t corner) {
  return light.irradiance.front[3 * light.corners[patch][corner]];
}

std::size_t far_sides(const test::LitPatches& lit) {
  const auto nodes = make_side_nodes(lit.patches, cosine_of_degrees(30.0f), Context(1));
  const NeedleNodes needles(lit.patches, nodes);
  std::size_t count = 0;
  for (std::uint32_t node = 0; node < nodes.size(); ++node) count += needles.at(node).size();
  return count;
}

TEST(NeedleNodes, light_runs_on_across_a_needle_and_its_own_counts_little) {
  const auto lit = panels(0.0f);
  // The left panel has two patches at the joint's upper end, the right one one; with their backs.
  EXPECT_EQ(far_sides(lit), 6u);
  const auto light = make_smooth_light(lit.patches, lit.solution);
  const auto left = light_at(light, 0, 2), right = light_at(light, 3, 2);
  EXPECT_NEAR(left, right, 0.01f);
  EXPECT_EQ(light_at(light, needle, 1), right);
  EXPECT_EQ(light_at(light, needle, 2), left);
  EXPECT_GT(left, 1.0f);
  EXPECT_LT(left, 2.2f);
}

TEST(NeedleNodes, across_a_bend_the_light_may_differ) {
  EXPECT_EQ(far_sides(panels(0.5f)), 6u);
  EXPECT_EQ(far_sides(panels(5.0f)), 0u);
}

TEST(NeedleNodes, a_narrow_bevel_at_one_end_does_not_part_them) {
  auto lit = panels(0.0f);
  const auto above = lit.vertex({1 + gap, 1.0018f, 0.0008f}),
             beside = lit.vertex({2 + gap, 1.0018f, 0.0008f});
  const std::uint32_t e = 4, g = 6;  // the upper edge of the right panel
  lit.patch({e, g, beside}, 9.0f);
  lit.patch({e, beside, above}, 9.0f);
  EXPECT_EQ(far_sides(lit), 6u);
  const auto light = make_smooth_light(lit.patches, lit.solution);
  EXPECT_NEAR(light_at(light, 0, 2), light_at(light, 3, 2), 0.05f);
}

TEST(NeedleNodes, of_needles_alone_each_is_as_good_as_the_others) {
  test::LitPatches lit;
  for (int i = 0; i < 6; ++i) lit.vertex({i % 2 == 0 ? 0.0f : 1.0f, 0.01f * static_cast<float>(i), 0});
  for (std::uint32_t i = 0; i < 4; ++i) lit.patch({i, i + 1, i + 2}, 1.0f);
  EXPECT_EQ(far_sides(lit), 0u);
}

}  // namespace
}  // namespace luxel
