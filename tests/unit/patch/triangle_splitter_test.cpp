// SPDX-License-Identifier: Apache-2.0
#include "luxel/patch/triangle_splitter.h"

#include <algorithm>
#include <array>
#include <map>

#include <gtest/gtest.h>

#include "luxel/patch/make_patches.h"

#include "support/truth_scenes.h"

namespace luxel {
namespace {

// Two strips of a curved wall: each 4 m long and 6 cm high, of two triangles.
PatchSet strips_of_patches(float max_edge) {
  truth::SceneBuilder b;
  b.material("wall", 0.5f, 0.0f)
      .quad({0, 0, 0}, {4, 0, 0}, {4, 0, 0.06f}, {0, 0, 0.06f})
      .quad({0, 0, 0.06f}, {4, 0, 0.06f}, {4, 0.01f, 0.12f}, {0, 0.01f, 0.12f});
  return make_patches(b.scene(), {.max_edge = max_edge});
}

TEST(TriangleSplitter, strips_become_parts_as_wide_as_they_are) {
  const auto patches = strips_of_patches(0.125f);
  double narrow = 0.0, all = 0.0;
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const auto c = patches.points(p);
    const auto longest =
        std::max({glm::distance(c[0], c[1]), glm::distance(c[1], c[2]), glm::distance(c[2], c[0])});
    const auto area = static_cast<double>(patches.area[p]);
    all += area;
    if (2.0 * area < 0.02 * static_cast<double>(longest)) narrow += area;  // less than a third of the strip
  }
  EXPECT_NEAR(all, 4.0 * (0.06 + std::hypot(0.06, 0.01)), 1e-5);
  EXPECT_LT(narrow, 0.15 * all);  // at the tips; all of it where triangles were halved alone
}

TEST(TriangleSplitter, parts_have_their_edges_in_common) {
  std::map<std::array<std::uint32_t, 2>, int> uses;
  const auto patches = strips_of_patches(0.1f);
  for (const auto& c : patches.corners)
    for (std::size_t k = 0; k < 3; ++k)
      ++uses[{std::min(c[k], c[(k + 1) % 3]), std::max(c[k], c[(k + 1) % 3])}];
  for (const auto& [edge, count] : uses) {
    const auto middle = 0.5f * (patches.vertices[edge[0]] + patches.vertices[edge[1]]);
    const bool is_border = middle.x == 0.0f || middle.x == 4.0f || middle.z == 0.0f || middle.z == 0.12f;
    EXPECT_EQ(count, is_border ? 1 : 2) << middle.x << ' ' << middle.z;
  }
}

}  // namespace
}  // namespace luxel
