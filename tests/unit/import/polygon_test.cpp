// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/polygon.h"

#include <cmath>
#include <map>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "luxel/core/triangle.h"

namespace luxel {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

Triangles cut(const std::vector<Vec3>& corners) {
  Triangles triangles;
  triangulate_polygon(corners, triangles);
  return triangles;
}

// The sum of the triangles' areas, each without sign: equal to the polygon's area only where no triangle lies
// outside or upon another.
double total_area(const std::vector<Vec3>& corners, const Triangles& triangles) {
  double sum = 0.0;
  for (const auto& [a, b, c] : triangles) sum += triangle_area(corners[a], corners[b], corners[c]);
  return sum;
}

// By the shoelace formula, for polygons in the plane z = 0.
double shoelace_area(const std::vector<Vec3>& corners) {
  double sum = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3d p(corners[i]), q(corners[(i + 1) % corners.size()]);
    sum += p.x * q.y - q.x * p.y;
  }
  return std::abs(sum) / 2.0;
}

void expect_exact_cover(const std::vector<Vec3>& corners) {
  const auto triangles = cut(corners);
  ASSERT_EQ(triangles.size(), corners.size() - 2);
  const auto area = shoelace_area(corners);
  EXPECT_NEAR(total_area(corners, triangles), area, 1e-9 * area);
}

std::vector<Vec3> ring(std::size_t n, float inner, float outer) {
  std::vector<Vec3> corners;
  for (std::size_t i = 0; i < n; ++i) {
    const auto angle = 2.0 * std::numbers::pi * double(i) / double(n);
    const auto radius = i % 2 == 0 ? outer : inner;
    corners.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
  }
  return corners;
}

TEST(Polygon, a_convex_one_is_the_fan_of_its_first_corner) {
  const auto triangles = cut(ring(6, 1.0f, 1.0f));
  EXPECT_EQ(triangles, (Triangles{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}}));
}

TEST(Polygon, a_dart_is_cut_inside_whichever_corner_comes_first) {
  std::vector<Vec3> dart = {Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(1, 1, 0), Vec3(0, 4, 0)};
  for (int i = 0; i < 4; ++i) {
    expect_exact_cover(dart);
    std::rotate(dart.begin(), dart.begin() + 1, dart.end());
  }
}

TEST(Polygon, keeps_its_winding_in_any_plane) {
  const std::vector<Vec3> l_shape = {Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(2, 1, 0),
                                     Vec3(1, 1, 0), Vec3(1, 2, 0), Vec3(0, 2, 0)};
  for (int axis = 0; axis < 3; ++axis)
    for (const bool is_reversed : {false, true}) {
      std::vector<Vec3> corners;
      for (const auto& p : l_shape)
        corners.push_back(axis == 0 ? Vec3(p.z, p.x, p.y) : axis == 1 ? Vec3(p.y, p.z, p.x) : p);
      if (is_reversed) std::reverse(corners.begin(), corners.end());
      Vec3 normal(0.0f);
      normal[axis] = is_reversed ? -1.0f : 1.0f;
      const auto triangles = cut(corners);
      ASSERT_EQ(triangles.size(), 4u);
      EXPECT_EQ(total_area(corners, triangles), 3.0);
      for (const auto& [a, b, c] : triangles)
        EXPECT_EQ(triangle_normal(corners[a], corners[b], corners[c]), normal);
    }
}

TEST(Polygon, far_from_the_origin_nothing_is_lost) {
  std::vector<Vec3> corners = {Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(2, 1, 0),
                               Vec3(1, 1, 0), Vec3(1, 2, 0), Vec3(0, 2, 0)};
  for (auto& p : corners) p += Vec3(1e6f, -3e6f, 2e6f);
  EXPECT_EQ(total_area(corners, cut(corners)), 3.0);
}

TEST(Polygon, a_hole_joined_by_a_seam_stays_a_hole) {
  expect_exact_cover({Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(4, 4, 0), Vec3(0, 4, 0), Vec3(0, 0, 0),
                      Vec3(1, 1, 0), Vec3(1, 3, 0), Vec3(3, 3, 0), Vec3(3, 1, 0), Vec3(1, 1, 0)});
}

TEST(Polygon, corners_along_an_edge_all_appear) {
  const std::vector<Vec3> corners = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0),
                                     Vec3(3, 0, 0), Vec3(3, 3, 0), Vec3(0, 3, 0)};
  expect_exact_cover(corners);
  std::vector<bool> has_area(corners.size(), false);
  for (const auto& [a, b, c] : cut(corners))
    if (triangle_area(corners[a], corners[b], corners[c]) > 0.0)
      has_area[a] = has_area[b] = has_area[c] = true;
  EXPECT_EQ(has_area, std::vector<bool>(corners.size(), true));
}

TEST(Polygon, a_spiral_is_covered_exactly) {
  std::vector<Vec3> corners;
  for (int i = 0; i < 20'000; ++i)
    corners.emplace_back((1.0 + 0.001 * i) * std::cos(0.02 * i), (1.0 + 0.001 * i) * std::sin(0.02 * i), 0.0);
  for (int i = 19'999; i >= 0; --i)
    corners.emplace_back((0.9 + 0.001 * i) * std::cos(0.02 * i), (0.9 + 0.001 * i) * std::sin(0.02 * i), 0.0);
  expect_exact_cover(corners);
}

TEST(Polygon, a_hundred_thousand_corners_are_no_trouble) { expect_exact_cover(ring(100'000, 2.0f, 2.5f)); }

TEST(Polygon, long_teeth_of_a_comb_are_cut_one_by_one) {
  std::vector<Vec3> comb = {Vec3(0, -1, 0)};
  for (int i = 0; i < 19'998; ++i)
    comb.emplace_back(19'997 - i, i % 2 == 0 ? 0.0f : 1.0f + 0.001f * float(i), 0);
  comb.front().x = 19'998;
  comb.emplace_back(-1, -1, 0);
  std::reverse(comb.begin(), comb.end());
  expect_exact_cover(comb);
}

TEST(Polygon, what_has_no_inside_is_answered_with_as_many_triangles) {
  const std::vector<std::vector<Vec3>> odd = {
      std::vector<Vec3>(7, Vec3(1, 2, 3)),                                               // a point
      {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(1, 0, 0), Vec3(5, 0, 0)},       // a line
      {Vec3(0, 0, 0), Vec3(1, 1, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)},                      // a bow tie
      {Vec3(0, 0, 0), Vec3(3, 1, 0), Vec3(0, 1, 0), Vec3(3, 0, 0), Vec3(1.4f, 3, 0)},    // a pentagram
      {Vec3(0, 0, 0), Vec3(1, 0, 1), Vec3(1, 1, 0), Vec3(0, 1, 1), Vec3(0.5f, 0.2f, 9)}  // not flat
  };
  for (const auto& corners : odd) {
    const auto triangles = cut(corners);
    ASSERT_EQ(triangles.size(), corners.size() - 2);
    for (const auto& triangle : triangles)
      for (const auto corner : triangle) EXPECT_LT(corner, corners.size());
  }
}

// Whatever the corners: each edge of the polygon is in one triangle, and each cut through it in two, there
// and back. A corner that was cut twice would break that.
TEST(Polygon, whatever_crosses_itself_is_cut_along_each_diagonal_once) {
  std::minstd_rand random(7);
  for (int round = 0; round < 3000; ++round) {
    std::vector<Vec3> corners(4 + random() % 12);
    for (auto& c : corners)  // few places, so that corners coincide and edges lie on each other
      c = {static_cast<float>(random() % 4), static_cast<float>(random() % 4),
           static_cast<float>(random() % 2)};
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (const auto& t : cut(corners))
      for (std::size_t i = 0; i < 3; ++i) ++edges[{t[i], t[(i + 1) % 3]}];
    const auto n = static_cast<std::uint32_t>(corners.size());
    for (const auto& [edge, count] : edges) {
      ASSERT_EQ(count, 1) << "round " << round;
      const bool of_polygon = (edge.first + 1) % n == edge.second;
      ASSERT_EQ(edges.contains({edge.second, edge.first}), !of_polygon) << "round " << round;
    }
  }
}

TEST(Polygon, noise_is_answered_in_bounded_time) {
  std::vector<Vec3> corners;
  std::uint32_t state = 1;
  const auto next = [&] { return float((state = state * 1664525u + 1013904223u) >> 8); };
  for (int i = 0; i < 5'000; ++i) corners.emplace_back(next(), next(), next());
  EXPECT_EQ(cut(corners).size(), corners.size() - 2);
}

TEST(Polygon, the_largest_coordinates_do_not_overflow) {
  const float big = 3e38f;
  const std::vector<Vec3> corners = {Vec3(-big, -big, 0), Vec3(big, -big, 0), Vec3(0, 0, 0),
                                     Vec3(-big, big, 0)};
  expect_exact_cover(corners);
}

}  // namespace
}  // namespace luxel
