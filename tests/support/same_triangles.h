// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "luxel/scene/scene.h"

namespace luxel::test {

// Each triangle of one scene is one of the other, with the same object and material, its corners moved by at
// most `distance` along each axis. The order of triangles, and the first corner of each, may differ.
inline void expect_same_triangles(const Scene& a, const Scene& b, double distance) {
  ASSERT_EQ(a.triangles.size(), b.triangles.size());
  const auto corners = [](const Scene& scene, std::size_t t, std::size_t first) {
    std::array<Vec3d, 3> found{};
    for (std::size_t i = 0; i < 3; ++i)
      found[i] = Vec3d(scene.positions[scene.triangles[t][(first + i) % 3]]) + scene.origin;
    return found;
  };
  const auto limit = 1.001 * distance + 1e-6;  // and the rounding of floats
  const auto is_same = [&](std::size_t t, std::size_t u) {
    if (a.objects.at(a.triangle_object[t]) != b.objects.at(b.triangle_object[u])) return false;
    if (a.materials[static_cast<std::size_t>(a.triangle_material[t])].name !=
        b.materials[static_cast<std::size_t>(b.triangle_material[u])].name)
      return false;
    for (std::size_t first = 0; first < 3; ++first) {
      const auto p = corners(a, t, 0), q = corners(b, u, first);
      bool is_near = true;
      for (std::size_t i = 0; i < 3; ++i) {
        const auto off = glm::abs(p[i] - q[i]);
        is_near = is_near && std::max({off.x, off.y, off.z}) <= limit;
      }
      if (is_near) return true;
    }
    return false;
  };
  std::vector<bool> is_taken(b.triangles.size());
  for (std::size_t t = 0; t < a.triangles.size(); ++t) {
    std::size_t u = 0;
    while (u < is_taken.size() && (is_taken[u] || !is_same(t, u))) ++u;
    ASSERT_LT(u, is_taken.size()) << "triangle " << t << " is not in the other scene";
    is_taken[u] = true;
  }
}

}  // namespace luxel::test
