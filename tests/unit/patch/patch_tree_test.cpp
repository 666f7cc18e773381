// SPDX-License-Identifier: Apache-2.0
#include "luxel/patch/patch_tree.h"

#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>

#include "luxel/patch/make_patches.h"

#include "support/truth_scenes.h"

namespace luxel {
namespace {

PatchSet cut(const Scene& scene, float max_edge) { return make_patches(scene, {.max_edge = max_edge}); }

// Many patches with one centroid: triangles of all sizes about a point, alike in pairs facing each other.
PatchSet coincident(std::size_t count) {
  auto patches =
      cut(truth::SceneBuilder().material("m", 0.5f, 1.0f).triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}).scene(),
          no_max_edge);
  for (auto i = patches.size(); i < count; ++i) {
    patches.corners.push_back(patches.corners[0]);
    patches.normal.push_back(i % 2 == 0 ? patches.normal[0] : -patches.normal[0]);
    patches.area.push_back(patches.area[0]);
    patches.material.push_back(patches.material[0]);
    patches.triangle.push_back(0);
  }
  return patches;
}

Vec3 centroid(const PatchSet& patches, std::size_t p) {
  const auto [a, b, c] = patches.points(p);
  return (a + b + c) / 3.0f;
}

void expect_sound(const PatchTree& tree, std::size_t patches) {
  auto sorted = tree.order;
  std::sort(sorted.begin(), sorted.end());
  std::vector<std::uint32_t> all(patches);
  std::iota(all.begin(), all.end(), 0u);
  EXPECT_EQ(sorted, all);

  ASSERT_EQ(tree.position.size(), patches);
  for (std::size_t i = 1; i < patches; ++i) ASSERT_LT(tree.position[i - 1], tree.position[i]);

  ASSERT_FALSE(tree.nodes.empty());
  EXPECT_EQ(tree.nodes[0].first, 0u);
  EXPECT_EQ(tree.nodes[0].count, patches);
  for (std::size_t k = 0; k < tree.nodes.size(); ++k) {
    const auto& node = tree.nodes[k];
    ASSERT_GT(node.count, 0u);
    if (node.child == 0) {
      ASSERT_LE(node.count, PatchTree::leaf_patches);
      continue;
    }
    ASSERT_GT(node.child, k);
    ASSERT_LT(node.child + 1u, tree.nodes.size());
    const auto& left = tree.nodes[node.child];
    const auto& right = tree.nodes[node.child + 1];
    ASSERT_EQ(left.first, node.first);
    ASSERT_EQ(right.first, left.first + left.count);
    ASSERT_EQ(left.count + right.count, node.count);
    ASSERT_TRUE(!node.is_flat || (left.is_flat && right.is_flat));
  }

  ASSERT_GE(tree.level_begin.size(), 2u);
  EXPECT_EQ(tree.level_begin.front(), 0u);
  EXPECT_EQ(tree.level_begin.back(), tree.nodes.size());
  EXPECT_TRUE(std::is_sorted(tree.level_begin.begin(), tree.level_begin.end()));

  // Regions follow one another, cover all, and begin where their size fits.
  std::uint32_t end = 0;
  for (const auto r : tree.regions) {
    const auto& node = tree.nodes[r];
    ASSERT_EQ(node.first, end);
    end = node.first + node.count;
    std::uint32_t unit = 1;
    while (unit < 64 && unit < node.count) unit *= 2;
    ASSERT_EQ(tree.position[node.first] % unit, 0u);
    ASSERT_EQ(tree.position[end - 1] - tree.position[node.first], node.count - 1);
  }
  EXPECT_EQ(end, patches);
}

void expect_same(const PatchTree& a, const PatchTree& b) {
  EXPECT_EQ(a.order, b.order);
  EXPECT_EQ(a.position, b.position);
  EXPECT_EQ(a.regions, b.regions);
  EXPECT_EQ(a.level_begin, b.level_begin);
  ASSERT_EQ(a.nodes.size(), b.nodes.size());
  for (std::size_t k = 0; k < a.nodes.size(); ++k) {
    ASSERT_EQ(a.nodes[k].first, b.nodes[k].first);
    ASSERT_EQ(a.nodes[k].count, b.nodes[k].count);
    ASSERT_EQ(a.nodes[k].child, b.nodes[k].child);
    ASSERT_EQ(a.nodes[k].is_flat, b.nodes[k].is_flat);
  }
}

TEST(PatchTree, is_sound_and_the_same_on_any_number_of_threads) {
  for (const auto& patches :
       {cut(truth::cube_a(), 0.05f), cut(truth::l_room(), 0.1f), cut(truth::sphere(40, 0.8f), no_max_edge),
        cut(truth::furnace(Vec3(0.5f), Vec3(0.3f)), 0.1f), coincident(1001)}) {
    const auto one = make_patch_tree(patches, Context(1));
    expect_sound(one, patches.size());
    for (const int threads : {2, 5}) expect_same(one, make_patch_tree(patches, Context(threads)));
  }
}

TEST(PatchTree, regions_of_a_box_lie_in_one_wall_each) {
  const auto patches = cut(truth::cube_a(), 0.1f);
  const auto tree = make_patch_tree(patches, Context(2));
  for (const auto r : tree.regions) {
    const auto& node = tree.nodes[r];
    EXPECT_TRUE(node.is_flat);
    const auto first = tree.order[node.first];
    for (auto i = node.first; i < node.first + node.count; ++i) {
      const auto p = tree.order[i];
      EXPECT_EQ(patches.material[p], patches.material[first]);
      EXPECT_NEAR(glm::dot(patches.normal[p], centroid(patches, p) - centroid(patches, first)), 0.0f, 1e-6f);
    }
  }
}

// Regions of flat surfaces: the normals of a region are similar, and the region is thin.
TEST(PatchTree, parts_a_sphere_into_sheets_that_bend_gently) {
  const auto patches = cut(truth::sphere(60, 0.8f), no_max_edge);
  const auto tree = make_patch_tree(patches, Context(2));
  EXPECT_GT(tree.regions.size(), 20u);
  EXPECT_LT(tree.regions.size(), patches.size() / 8);
  for (const auto r : tree.regions) {
    const auto& node = tree.nodes[r];
    Vec3 mean(0.0f);
    for (auto i = node.first; i < node.first + node.count; ++i) mean += patches.normal[tree.order[i]];
    mean = glm::normalize(mean);
    for (auto i = node.first; i < node.first + node.count; ++i)
      EXPECT_GT(glm::dot(mean, patches.normal[tree.order[i]]), 0.89f);
  }
}

// Halves of a region begin at multiples of a power of two not far below their size, so that a sequence laid
// along the positions is spread evenly over both.
TEST(PatchTree, halves_begin_at_round_positions) {
  const auto patches = cut(truth::cube_a(), 0.05f);
  const auto tree = make_patch_tree(patches, Context(2));
  for (const auto& node : tree.nodes) {
    if (!node.is_flat || node.child == 0) continue;
    const auto left = tree.nodes[node.child].count;
    std::uint32_t unit = 1;
    while (unit * 16 <= node.count) unit *= 2;
    EXPECT_EQ(left % unit, 0u);
    EXPECT_NEAR(left, node.count / 2.0, std::max(1.0, unit / 2.0 + 0.5));
  }
}

TEST(PatchTree, of_one_patch_is_one_leaf) {
  const auto tree = make_patch_tree(coincident(1), Context(2));
  expect_sound(tree, 1);
  ASSERT_EQ(tree.nodes.size(), 1u);
  EXPECT_TRUE(tree.nodes[0].is_flat);
  EXPECT_EQ(tree.regions, std::vector<std::uint32_t>{0});
}

}  // namespace
}  // namespace luxel
