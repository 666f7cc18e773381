// SPDX-License-Identifier: Apache-2.0
#include "luxel/surface/cut_along_edges.h"

#include <set>

#include <gtest/gtest.h>

namespace luxel {
namespace {

using Fractions = std::array<std::vector<double>, 3>;  // [edge]: of the way along it

std::vector<BorderPoint> border(const std::array<Vec3d, 3>& corners, const Fractions& fractions) {
  std::vector<BorderPoint> points;
  for (std::size_t k = 0; k < 3; ++k) {
    points.push_back({corners[k], 1u << k | 1u << (k + 2) % 3});
    for (const auto s : fractions[k])
      points.push_back({corners[k] + s * (corners[(k + 1) % 3] - corners[k]), 1u << k});
  }
  return points;
}

// Every piece has area and the triangle's winding, they make up all of it, and each stretch of the border
// between two neighbouring points is an edge of just one.
void expect_sound(const std::array<Vec3d, 3>& corners, const Fractions& fractions) {
  const auto points = border(corners, fractions);
  const auto fragments = cut_along_edges(points);
  EXPECT_EQ(fragments.size(), points.size() - 2);
  const auto whole = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
  double sum = 0.0;
  std::multiset<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const auto& t : fragments) {
    const auto area =
        glm::dot(glm::cross(points[t[1]].place - points[t[0]].place, points[t[2]].place - points[t[0]].place),
                 whole) /
        glm::dot(whole, whole);
    EXPECT_GT(area, 1e-9);
    sum += area;
    for (std::size_t k = 0; k < 3; ++k) edges.insert({t[k], t[(k + 1) % 3]});
  }
  EXPECT_NEAR(sum, 1.0, 1e-12);
  for (std::uint32_t i = 0; i < points.size(); ++i)
    EXPECT_EQ(edges.count({i, static_cast<std::uint32_t>((i + 1) % points.size())}), 1u) << "stretch " << i;
}

TEST(CutAlongEdges, all_points_become_corners_and_no_piece_is_a_line) {
  const std::array<Vec3d, 3> corners = {Vec3d(0, 0, 0), Vec3d(3, 0.1, 1), Vec3d(1, 0.2, 4)};
  expect_sound(corners, {});
  expect_sound(corners, {{{0.5}, {}, {}}});
  expect_sound(corners, {{{}, {0.1, 0.11, 0.9}, {}}});
  expect_sound(corners, {{{0.25, 0.5, 0.75}, {0.5}, {}}});
  expect_sound(corners, {{{0.5}, {0.3, 0.6}, {0.01, 0.02, 0.03, 0.99}}});
  expect_sound({Vec3d(0, 0, 0), Vec3d(1, 0, 0), Vec3d(0.3, 1e-4, 0)}, {{{0.2, 0.4}, {0.5}, {0.5, 0.6}}});
}

TEST(CutAlongEdges, one_point_halves_a_triangle) {
  const auto points = border({Vec3d(0, 0, 0), Vec3d(2, 0, 0), Vec3d(0, 1, 0)}, {{{}, {0.5}, {}}});
  const auto fragments = cut_along_edges(points);
  ASSERT_EQ(fragments.size(), 2u);
  for (const auto& piece : fragments)
    EXPECT_TRUE(std::count(piece.begin(), piece.end(), 0u) == 1 &&
                std::count(piece.begin(), piece.end(), 2u) == 1);
}

}  // namespace
}  // namespace luxel
