// SPDX-License-Identifier: Apache-2.0
#include "luxel/lamps/join_lamps.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "luxel/core/triangle.h"

namespace luxel {
namespace {

using Shape = std::function<Vec3(float u, float v)>;  // of the unit square

// n times n cells of two triangles each, but for those that are left out.
std::vector<LampFacet> mesh(
    int n, const Shape& shape,
    const std::function<bool(int, int)>& is_hole = [](int, int) { return false; }) {
  const auto at = [&](int i, int j) {
    return shape(static_cast<float>(i) / static_cast<float>(n),
                 static_cast<float>(j) / static_cast<float>(n));
  };
  std::vector<LampFacet> facets;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      if (is_hole(i, j)) continue;
      facets.push_back({{at(i, j), at(i + 1, j), at(i + 1, j + 1)}, 0});
      facets.push_back({{at(i, j), at(i + 1, j + 1), at(i, j + 1)}, 0});
    }
  return facets;
}

Vec3 tilted(float u, float v) {
  return Vec3(3.0f, -2.0f, 5.0f) + u * Vec3(1.1f, 0.3f, -0.2f) + v * Vec3(-0.1f, 0.7f, 0.4f);
}

std::size_t lamps_of(const std::vector<LampFacet>& facets) {
  const auto lamps = join_lamps(facets);
  std::vector<int> times(facets.size(), 0);
  double before = 0.0;
  double after = 0.0;
  for (const auto& p : facets) before += triangle_area(p.corner[0], p.corner[1], p.corner[2]);
  for (const auto& lamp : lamps) {
    for (const auto p : lamp.facets) ++times[p];
    for (std::size_t i = 2; i < lamp.corners.size(); ++i)
      after += triangle_area(lamp.corners[0], lamp.corners[i - 1], lamp.corners[i]);
  }
  EXPECT_TRUE(std::all_of(times.begin(), times.end(), [](int t) { return t == 1; }));
  EXPECT_NEAR(after / before, 1.0, 1e-6);
  return lamps.size();
}

TEST(JoinLamps, a_meshed_panel_is_a_panel_again_however_it_hangs) {
  for (const int n : {2, 3, 12}) {
    const auto lamps = join_lamps(mesh(n, tilted));
    ASSERT_EQ(lamps.size(), 1u) << n;
    EXPECT_EQ(lamps[0].corners.size(), 4u);
    EXPECT_EQ(lamps_of(mesh(n, tilted)), 1u);
  }
}

TEST(JoinLamps, what_is_folded_bent_or_has_a_hole_stays_in_pieces) {
  const auto folded = mesh(4, [](float u, float v) { return Vec3(u, v, 0.01f * std::fabs(u - 0.5f)); });
  EXPECT_EQ(lamps_of(folded), 2u);  // two flat halves
  const auto bent = mesh(8, [](float u, float v) { return Vec3(u, v, 0.1f * u * u); });
  EXPECT_EQ(lamps_of(bent), 8u);  // eight flat strips
  const auto slightly_bent = mesh(8, [](float u, float v) { return Vec3(u, v, 1e-3f * u * u); });
  EXPECT_EQ(lamps_of(slightly_bent), 128u);
  const auto l_shaped = mesh(4, tilted, [](int i, int j) { return i >= 2 && j >= 2; });
  EXPECT_EQ(lamps_of(l_shaped), l_shaped.size());
  const auto frame = mesh(4, tilted, [](int i, int j) { return i == 1 && j == 2; });
  EXPECT_EQ(lamps_of(frame), frame.size());
}

TEST(JoinLamps, other_materials_and_doubled_pieces_are_kept_apart) {
  auto striped = mesh(6, tilted);
  for (std::size_t i = 0; i < striped.size(); ++i) striped[i].surface = i < 36 ? 0 : 1;
  EXPECT_EQ(lamps_of(striped), 2u);
  auto doubled = mesh(6, tilted);
  const auto once = doubled;
  doubled.insert(doubled.end(), once.begin(), once.end());
  EXPECT_EQ(lamps_of(doubled), doubled.size());
}

TEST(JoinLamps, two_triangles_and_a_disc_of_few_stay_as_they_are) {
  EXPECT_EQ(lamps_of(mesh(1, tilted)), 2u);
  std::vector<LampFacet> disc;
  const auto rim = [](int i) {
    const auto angle = 2.0 * M_PI * (i % 24) / 24.0;
    return Vec3(static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)), 1.0f);
  };
  for (int i = 0; i < 24; ++i) disc.push_back({{Vec3(0, 0, 1), rim(i), rim(i + 1)}, 0});
  EXPECT_EQ(lamps_of(disc), 24u);
}

}  // namespace
}  // namespace luxel
