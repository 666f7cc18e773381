// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "scenes/shapes/dice.h"
#include "scenes/shapes/sheets.h"
#include "scenes/shapes/solids.h"
#include "scenes/shapes/split.h"
#include "scenes/shapes/sweeping.h"
#include "scenes/shapes/turning.h"

namespace luxel::scenes {
namespace {

double area(const Mesh& mesh) {
  auto sum = 0.0;
  for (const auto& triangle : mesh.triangles) sum += glm::length(area_vector(mesh, triangle));
  return sum;
}

// By Gauss's theorem; positive where faces look outwards.
double volume(const Mesh& mesh) {
  auto sum = 0.0;
  for (const auto& triangle : mesh.triangles) {
    sum += glm::dot(centroid(mesh, triangle), area_vector(mesh, triangle)) / 3.0;
  }
  return sum;
}

TEST(Solids, a_box_has_the_volume_and_area_of_a_box) {
  EXPECT_NEAR(volume(box({2.0, 3.0, 5.0})), 30.0, 1e-12);
  EXPECT_NEAR(area(box({2.0, 3.0, 5.0})), 62.0, 1e-12);
  EXPECT_NEAR(volume(cut_box({-1.0, 0.0, 1.0}, 3.0, {-2.5, 1.0, 2.5})), 30.0, 1e-12);
}

TEST(Solids, a_rounded_box_is_a_little_smaller_than_its_box_and_larger_than_its_core) {
  const auto rounded_volume = volume(rounded_box({2.0, 3.0, 5.0}, 0.2, {2, 3, 4}));
  // Steiner's formula for the core 1.6 x 2.6 x 4.6 grown by a ball of 0.2; facets cut off a little.
  const auto core = 1.6 * 2.6 * 4.6;
  const auto faces = 2.0 * (1.6 * 2.6 + 2.6 * 4.6 + 4.6 * 1.6) * 0.2;
  const auto edges = std::numbers::pi * (1.6 + 2.6 + 4.6) * 0.04;
  const auto corners = 4.0 / 3.0 * std::numbers::pi * 0.008;
  const auto exact = core + faces + edges + corners;
  EXPECT_LT(rounded_volume, exact);
  EXPECT_NEAR(rounded_volume, exact, 0.003 * exact);
}

TEST(Solids, a_prism_has_the_volume_of_its_outline_times_its_depth) {
  EXPECT_NEAR(volume(prism({{0.0, 0.0}, {2.0, 0.0}, {2.0, 1.0}}, 3.0)), 3.0, 1e-12);
}

TEST(Solids, a_lathe_turns_a_cone_and_a_sphere) {
  // A regular n-gon in the unit circle has n/2 sin(2 pi/n) of area instead of pi.
  const auto ring = 12.0 * std::sin(2.0 * std::numbers::pi / 24.0);
  EXPECT_NEAR(volume(lathe({{0.0, 0.0}, {1.0, 0.0}, {0.0, 3.0}}, 24)), ring, 1e-12);
  EXPECT_NEAR(volume(sphere(1.0, 100)), 4.0 / 3.0 * std::numbers::pi, 0.01);
}

TEST(Solids, a_tube_has_its_cross_section_along_its_whole_path) {
  const auto section = 8.0 * std::sin(2.0 * std::numbers::pi / 16.0) * 0.01;
  EXPECT_NEAR(volume(tube({{1.0, 1.0, 1.0}, {1.0, 4.0, 5.0}}, 0.1, 16)), 5.0 * section, 1e-12);
}

TEST(Solids, a_frame_is_mitred_round_its_opening) {
  // Between the outer 3 x 4 and the inner 2 x 3 rectangle, 0.1 thick.
  const auto mesh = frame(2.0, 3.0, {{0.0, 0.0}, {0.5, 0.0}, {0.5, 0.1}, {0.0, 0.1}});
  EXPECT_NEAR(volume(mesh), (12.0 - 6.0) * 0.1, 1e-12);
}

TEST(Sheets, a_panel_leaves_out_its_holes) {
  const auto mesh = panel({}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 1.0, 2.0, 4.0}, {0.0, 1.0, 3.0},
                          [](double a, double b) { return a > 1.0 && a < 2.0 && b < 1.0; });
  EXPECT_NEAR(area(mesh), 11.0, 1e-12);
  EXPECT_GT(area_vector(mesh, mesh.triangles.front()).z, 0.0);
}

TEST(Sheets, steps_are_equal_between_stops_and_never_too_long) {
  EXPECT_EQ(steps({0.0, 1.0, 1.5}, 0.5), (std::vector<double>{0.0, 0.5, 1.0, 1.5}));
}

TEST(Split, keeps_area_volume_and_paint) {
  const auto fine = split(painted(box({2.0, 3.0, 5.0}), Paint::walnut), 4);
  EXPECT_EQ(fine.triangles.size(), 12u * 16u);
  EXPECT_EQ(welded(fine).points.size(), fine.points.size()) << "neighbours share their points";
  EXPECT_NEAR(volume(fine), 30.0, 1e-12);
  EXPECT_NEAR(area(fine), 62.0, 1e-12);
  for (const auto& triangle : fine.triangles) {
    EXPECT_EQ(triangle.paint, Paint::walnut);
    EXPECT_GT(glm::length(area_vector(fine, triangle)), 0.99 * 3.0 / 16.0) << "a sixteenth of its triangle";
  }
}

TEST(Dice, depend_on_their_address_alone) {
  const auto second = dice(1, 2, 3);
  EXPECT_EQ(dice(1, 2, 3), second);
  EXPECT_NE(dice(1, 2, 4), second);
  EXPECT_NE(dice(1, 3, 3), second);
  auto sum = 0.0;
  for (auto k = 0u; k < 10'000; ++k) sum += dice(5, k);
  // The mean of 10,000 fair dice has the standard deviation 1 / sqrt(12 * 10,000) = 0.0029.
  EXPECT_NEAR(sum / 10'000, 0.5, 4.0 * 0.0029);
}

}  // namespace
}  // namespace luxel::scenes
