// SPDX-License-Identifier: Apache-2.0
// Triangulations of flat surfaces against the definition of Delaunay's, area by area and edge by edge.
#include "luxel/scene/halve_needles.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "luxel/core/none.h"
#include "luxel/core/vector.h"

namespace luxel {
namespace {

constexpr std::int64_t metre = FragmentMesh::grid / 32;  // in steps of the grid

double area_of(const FragmentMesh& mesh) {
  double sum = 0.0;
  for (const auto& f : mesh.fragments())
    sum += 0.5 * static_cast<double>(mesh.turn(f.v[0], f.v[1], f.v[2])) / std::pow(metre, 2.0);
  return sum;
}

// The angle opposite an edge, radians.
double angle_opposite(const FragmentMesh& mesh, FragmentMesh::Edge e) {
  const auto to = [&](std::uint32_t end) {
    const auto &p = mesh.points()[mesh.apex(e)], &q = mesh.points()[end];
    return glm::dvec2(q.x - p.x, q.y - p.y);
  };
  const auto a = to(mesh.from(e)), b = to(mesh.to(e));
  return std::atan2(a.x * b.y - a.y * b.x, glm::dot(a, b));
}

// Every fragment turns to the left, and neighbours name each other across the same edge.
void expect_whole(const FragmentMesh& mesh) {
  for (std::uint32_t f = 0; f < mesh.fragments().size(); ++f) {
    const auto& fragment = mesh.fragments()[f];
    EXPECT_GT(mesh.turn(fragment.v[0], fragment.v[1], fragment.v[2]), 0);
    for (std::uint32_t k = 0; k < 3; ++k) {
      const auto other = mesh.other_side({f, k});
      if (other.fragment == none) continue;
      EXPECT_EQ(mesh.fragments()[other.fragment].across[other.k], f);
      EXPECT_EQ(mesh.from(other), mesh.to({f, k}));
      EXPECT_EQ(mesh.to(other), mesh.from({f, k}));
    }
  }
}

void expect_delaunay(const FragmentMesh& mesh) {
  for (std::uint32_t f = 0; f < mesh.fragments().size(); ++f)
    for (std::uint32_t k = 0; k < 3; ++k) {
      const auto other = mesh.other_side({f, k});
      if (other.fragment == none) continue;
      EXPECT_LE(angle_opposite(mesh, {f, k}) + angle_opposite(mesh, other), std::numbers::pi + 1e-6);
    }
}

// A convex polygon as a fan around its first corner.
FragmentMesh fan(const std::vector<glm::dvec2>& corners) {
  std::vector<FragmentMesh::Point> points;
  for (const auto& p : corners) points.push_back({std::llround(p.x * metre), std::llround(p.y * metre)});
  std::vector<FragmentMesh::Fragment> fragments;
  const auto last = static_cast<std::uint32_t>(corners.size()) - 3;
  for (std::uint32_t i = 0; i <= last; ++i)
    fragments.push_back({{0, i + 1, i + 2}, {i == 0 ? none : i - 1, none, i == last ? none : i + 1}});
  return {std::move(points), std::move(fragments)};
}

// A wall of 20 m x 1 m whose upper edge has a vertex every 0.25 m, as a fan around its lower left corner.
FragmentMesh wall() {
  std::vector<glm::dvec2> corners{{0.0, 0.0}, {20.0, 0.0}};
  for (int i = 80; i >= 0; --i) corners.push_back({0.25 * i, 1.0});
  return fan(corners);
}

TEST(HalveNeedles, edges_are_turned_until_all_are_delaunay) {
  auto mesh = wall();
  make_delaunay(mesh, 1.0);
  expect_whole(mesh);
  expect_delaunay(mesh);
  EXPECT_NEAR(area_of(mesh), 20.0, 1e-9);
}

TEST(HalveNeedles, polygons_with_random_corners_become_delaunay_too) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> turn(0.0, 2.0 * std::numbers::pi);
  for (int run = 0; run < 50; ++run) {
    std::vector<double> turns(12);
    for (auto& t : turns) t = turn(random);
    std::sort(turns.begin(), turns.end());
    std::vector<glm::dvec2> corners;
    for (const auto t : turns) corners.push_back({3.0 + 3.0 * std::cos(t), 1.0 + std::sin(t)});
    auto mesh = fan(corners);
    const auto area = area_of(mesh);
    make_delaunay(mesh, 1.0);
    expect_whole(mesh);
    expect_delaunay(mesh);
    EXPECT_NEAR(area_of(mesh), area, 1e-12 * area);
  }
}

TEST(HalveNeedles, needles_in_a_wall_are_halved_until_none_is_left) {
  auto mesh = wall();
  const NeedleLimits limits{.slenderness = 8.0, .longest = 0.1 * metre, .min_height = 1.0, .points = 1000};
  make_delaunay(mesh, limits.min_height);
  const auto before = mesh.points().size();
  const auto halved = halve_needles(mesh, limits);
  ASSERT_EQ(before + halved.size(), mesh.points().size());
  EXPECT_GT(halved.size(), 0u);
  EXPECT_LT(halved.size(), 100u);
  for (std::size_t i = 0; i < halved.size(); ++i) {
    const auto [a, b] = halved[i];
    ASSERT_LT(std::max(a, b), before + i);
    const auto &p = mesh.points()[a], &q = mesh.points()[b], &middle = mesh.points()[before + i];
    EXPECT_EQ(middle.x, (p.x + q.x) / 2);
    EXPECT_EQ(middle.y, (p.y + q.y) / 2);
  }
  expect_whole(mesh);
  expect_delaunay(mesh);
  EXPECT_NEAR(area_of(mesh), 20.0, 1e-7);
  for (std::uint32_t f = 0; f < mesh.fragments().size(); ++f) EXPECT_FALSE(is_needle_inside(mesh, f, limits));
}

TEST(HalveNeedles, halves_of_a_narrow_rectangle_are_no_needles_of_a_fan) {
  const auto strip = fan({{0.0, 0.0}, {5.0, 0.0}, {5.0, 0.01}, {0.0, 0.01}});
  EXPECT_FALSE(is_needle_inside(strip, 0, {}));
  EXPECT_FALSE(is_needle_inside(strip, 1, {}));
}

TEST(HalveNeedles, no_more_points_are_added_than_allowed) {
  auto mesh = wall();
  make_delaunay(mesh, 1.0);
  EXPECT_EQ(halve_needles(mesh, {.slenderness = 2.5, .min_height = 1.0, .points = 7}).size(), 7u);
  expect_whole(mesh);
  EXPECT_NEAR(area_of(mesh), 20.0, 1e-7);
}

}  // namespace
}  // namespace luxel
