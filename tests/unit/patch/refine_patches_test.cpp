// SPDX-License-Identifier: Apache-2.0
#include "luxel/patch/refine_patches.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include <gtest/gtest.h>

#include "luxel/core/address.h"
#include "luxel/patch/make_patches.h"

#include "support/truth_scenes.h"

namespace luxel {
namespace {

double total_area(const PatchSet& patches) {
  return std::accumulate(patches.area.begin(), patches.area.end(), 0.0);
}

// Degrees.
double smallest_angle(const PatchSet& patches) {
  double max_cosine = -1.0;
  for (std::size_t p = 0; p < patches.size(); ++p)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto q = patches.points(p);
      const auto a = glm::normalize(Vec3d(q[(k + 1) % 3]) - Vec3d(q[k]));
      const auto b = glm::normalize(Vec3d(q[(k + 2) % 3]) - Vec3d(q[k]));
      max_cosine = std::max(max_cosine, glm::dot(a, b));
    }
  return std::acos(max_cosine) * 180.0 / 3.14159265358979;
}

// Those near a line that crosses rooms, as light would have it, and a few at random.
std::vector<std::uint8_t> near_a_line(const PatchSet& patches, int round) {
  std::vector<std::uint8_t> marks(patches.size(), 0);
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const auto c = patches.centroid(p);
    const auto off = std::abs(c.x + 0.37f * c.y - 0.61f * c.z - 0.4f);
    const auto lot = stream_key(7, static_cast<std::uint32_t>(round), static_cast<std::uint32_t>(p)) % 64;
    marks[p] = off < 0.5f / static_cast<float>(1 << round) || lot == 0 ? 1 : 0;
  }
  return marks;
}

void expect_closed(const PatchSet& patches) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
  for (const auto& c : patches.corners)
    for (std::size_t k = 0; k < 3; ++k) ++uses[{c[k], c[(k + 1) % 3]}];
  std::size_t faults = 0;
  for (const auto& [ends, count] : uses)
    if (count != 1 || uses.count({ends.second, ends.first}) != 1) ++faults;
  EXPECT_EQ(faults, 0u);
}

TEST(RefinePatches, a_closed_room_stays_closed_keeps_its_area_and_its_angles) {
  auto patches = make_patches(truth::l_room(), {.max_edge = 0.6f});
  const auto angle = smallest_angle(patches);
  for (int round = 0; round < 7; ++round) {
    const auto marks = near_a_line(patches, round);
    const auto refined = refine_patches(patches, marks);
    std::vector<int> parts(patches.size(), 0);
    for (std::size_t p = 0; p < refined.patches.size(); ++p) {
      ++parts[refined.parent[p]];
      EXPECT_EQ(refined.patches.triangle[p], patches.triangle[refined.parent[p]]);
    }
    for (std::size_t p = 0; p < patches.size(); ++p)
      EXPECT_TRUE(marks[p] == 0 ? parts[p] >= 1 : parts[p] == 4);
    EXPECT_TRUE(std::is_sorted(refined.parent.begin(), refined.parent.end()));
    patches = refined.patches;
    expect_closed(patches);
    EXPECT_NEAR(total_area(patches), 14.0, 1e-4);
    EXPECT_GE(smallest_angle(patches), 0.5 * angle - 1e-3);  // Rivara 1984
  }
  EXPECT_GT(patches.size(), 3000u);
}

TEST(RefinePatches, needles_are_cut_across_in_three) {
  truth::SceneBuilder b;
  b.material("m", 0.5f, 1.0f).triangle({0, 0, 0}, {1, 0, 0}, {1, 0.05f, 0});
  auto patches = make_patches(b.scene(), {.max_edge = no_max_edge});
  const auto angle = smallest_angle(patches);
  float longest = glm::distance(patches.points(0)[2], patches.points(0)[0]);
  for (const std::size_t expected : {3u, 9u, 27u}) {
    patches = refine_patches(patches, std::vector<std::uint8_t>(patches.size(), 1)).patches;
    EXPECT_EQ(patches.size(), expected);
    longest *= 0.5f;
    for (std::size_t p = 0; p < patches.size(); ++p)
      for (std::size_t k = 0; k < 3; ++k)
        EXPECT_LT(glm::distance(patches.points(p)[k], patches.points(p)[(k + 1) % 3]), 1.04f * longest);
    EXPECT_GE(smallest_angle(patches), 0.5 * angle);
    EXPECT_NEAR(total_area(patches), 0.025, 1e-8);
  }
}

// A panel of 1 x 1 m, a strip of 1 cm, and another panel, which is turned about the strip's edge. The patch
// of the first panel at the strip is marked; returns the vertices on the edge of the other one.
std::size_t vertices_across_a_strip(float degrees) {
  const auto dx = std::cos(glm::radians(degrees)), dz = std::sin(glm::radians(degrees));
  truth::SceneBuilder b;
  b.material("m", 0.5f, 1.0f);
  b.triangle({-1, 0, 0}, {0, 0, 0}, {0, 1, 0}).triangle({-1, 0, 0}, {0, 1, 0}, {-1, 1, 0});
  b.triangle({0, 0, 0}, {0.01f, 0, 0}, {0.01f, 1, 0}).triangle({0, 0, 0}, {0.01f, 1, 0}, {0, 1, 0});
  b.triangle({0.01f, 0, 0}, {0.01f + dx, 0, dz}, {0.01f, 1, 0});
  const auto patches = make_patches(b.scene(), {.max_edge = no_max_edge});
  EXPECT_EQ(patches.size(), 5u);
  const auto refined = refine_patches(patches, std::vector<std::uint8_t>{1, 0, 0, 0, 0}).patches;
  const auto& all = refined.vertices;
  const auto at_strip = [](float x) { return [x](const Vec3& v) { return std::abs(v.x - x) < 1e-6f; }; };
  EXPECT_EQ(std::count_if(all.begin(), all.end(), at_strip(0.0f)), 3);
  return static_cast<std::size_t>(std::count_if(all.begin(), all.end(), at_strip(0.01f)));
}

TEST(RefinePatches, needles_between_panels_of_one_plane_are_cut_for_both) {
  EXPECT_EQ(vertices_across_a_strip(0.0f), 3u);
  EXPECT_EQ(vertices_across_a_strip(60.0f), 2u);
}

TEST(RefinePatches, without_marks_it_is_the_same_set) {
  const auto patches = make_patches(truth::l_room(), {.max_edge = 0.6f});
  const auto same = refine_patches(patches, std::vector<std::uint8_t>(patches.size(), 0)).patches;
  EXPECT_EQ(same.corners, patches.corners);
  EXPECT_EQ(same.vertices, patches.vertices);
  EXPECT_EQ(same.area, patches.area);
}

TEST(RefinePatches, halves_of_an_edge_inherit_its_contact) {
  truth::SceneBuilder b;
  b.material("m", 0.5f, 1.0f).quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
  auto patches = make_patches(b.scene(), {.max_edge = no_max_edge});
  ASSERT_EQ(patches.size(), 2u);
  // The diagonal, which both triangles share.
  const auto& c = patches.corners;
  std::vector<std::uint32_t> shared;
  for (const auto v : c[0])
    if (std::count(c[1].begin(), c[1].end(), v) == 1) shared.push_back(v);
  ASSERT_EQ(shared.size(), 2u);
  patches.contacts = {{{std::min(shared[0], shared[1]), std::max(shared[0], shared[1])}, Vec3(0, 0, 1)}};
  for (std::size_t fragments = 2; fragments <= 8; fragments *= 2) {
    patches = refine_patches(patches, std::vector<std::uint8_t>(patches.size(), 1)).patches;
    ASSERT_EQ(patches.contacts.size(), fragments);
    double length = 0.0;
    for (const auto& contact : patches.contacts) {
      const auto &p = patches.vertices[contact.edge[0]], &q = patches.vertices[contact.edge[1]];
      EXPECT_LT(contact.edge[0], contact.edge[1]);
      EXPECT_EQ(p.x, p.y);
      EXPECT_EQ(q.x, q.y);
      EXPECT_EQ(contact.into, Vec3(0, 0, 1));
      length += static_cast<double>(glm::distance(p, q));
    }
    EXPECT_NEAR(length, std::sqrt(2.0), 1e-6);
  }
}

}  // namespace
}  // namespace luxel
