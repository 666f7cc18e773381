// SPDX-License-Identifier: Apache-2.0
#include "luxel/surface/patch_cuts.h"

#include <gtest/gtest.h>

#include "luxel/core/triangle.h"

#include "support/lit_patches.h"

namespace luxel {
namespace {

// A patch whose first edge has two vertices of others on it, and its second edge one.
TEST(PatchCuts, a_patch_is_cut_at_every_vertex_on_its_border) {
  test::LitPatches lit;
  const auto a = lit.vertex({0, 0, 0}), b = lit.vertex({3, 0, 0}), c = lit.vertex({0, 3, 0});
  const auto p = lit.vertex({1, 0, 0}), q = lit.vertex({2, 0, 0}), r = lit.vertex({1.5f, 1.5f, 0});
  const auto low = lit.vertex({1.5f, -2, 0}), high = lit.vertex({3, 3, 0});
  lit.patch({a, b, c}, 1.0f);
  for (const auto& corners : {std::array{p, a, low}, {q, p, low}, {b, q, low}, {r, b, high}, {c, r, high}})
    lit.patch(corners, 1.0f);
  const auto cuts = cut_at_hanging_vertices(lit.patches);
  ASSERT_EQ(cuts.size(), 1u);
  const auto& cut = cuts.front();
  EXPECT_EQ(cut.patch, 0u);
  std::vector<std::uint32_t> around;
  for (const auto& point : cut.points) around.push_back(point.vertex);
  EXPECT_EQ(around, (std::vector{a, p, q, b, r, c}));
  double area = 0.0;
  for (const auto& t : cut.triangles) {
    const auto at = [&](std::size_t i) { return lit.patches.vertices[cut.points[t[i]].vertex]; };
    EXPECT_GT(triangle_normal(at(0), at(1), at(2)).z, 0.9f);
    area += triangle_area(at(0), at(1), at(2));
  }
  EXPECT_EQ(cut.triangles.size(), 4u);
  EXPECT_NEAR(area, 4.5, 1e-6);
  for (const auto& point : cut.points) {
    const auto w = point.weights();
    const auto place = w.x * Vec3(0, 0, 0) + w.y * Vec3(3, 0, 0) + w.z * Vec3(0, 3, 0);
    EXPECT_LT(glm::length(place - lit.patches.vertices[point.vertex]), 1e-5f);
  }
}

// A wall along an edge that two patches of the floor share: its foot has no other patch, and the floor's
// vertex on it belongs to no open edge.
TEST(PatchCuts, a_wall_is_cut_where_the_floor_below_it_is) {
  test::LitPatches lit;
  const auto a = lit.vertex({0, 0, 0}), b = lit.vertex({2, 0, 0}), middle = lit.vertex({0.5f, 0, 0});
  const auto left = lit.vertex({0.5f, 1, 0}), right = lit.vertex({0.5f, -1, 0}), top = lit.vertex({1, 0, 2});
  lit.patch({a, b, top}, 1.0f);
  for (const auto& corners :
       {std::array{a, right, middle}, {right, b, middle}, {b, left, middle}, {left, a, middle}})
    lit.patch(corners, 1.0f);
  const auto cuts = cut_at_hanging_vertices(lit.patches);
  ASSERT_EQ(cuts.size(), 1u);
  EXPECT_EQ(cuts.front().patch, 0u);
  EXPECT_EQ(cuts.front().triangles.size(), 2u);
}

TEST(PatchCuts, a_mesh_whose_patches_share_their_edges_has_none) {
  test::LitPatches lit;
  for (const auto& p : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)}) lit.vertex(p);
  lit.patch({0, 1, 2}, 1.0f);
  lit.patch({0, 2, 3}, 1.0f);
  EXPECT_TRUE(cut_at_hanging_vertices(lit.patches).empty());
}

}  // namespace
}  // namespace luxel
