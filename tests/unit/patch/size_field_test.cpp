// SPDX-License-Identifier: Apache-2.0
#include "luxel/patch/size_field.h"

#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "luxel/patch/make_patches.h"

#include "support/truth_scenes.h"

namespace luxel {
namespace {

constexpr int sectors = 64;
constexpr float radius = 0.15f;  // m
constexpr Vec3 centre{2.1f, 1.9f, 0.0f};

Vec3 on_circle(int sector) {
  const auto angle = 2.0f * std::numbers::pi_v<float> * static_cast<float>(sector) / sectors;
  return centre + radius * Vec3(std::cos(angle), std::sin(angle), 0.0f);
}

// A triangle in the plane z = 0 and the outline of a round foot on it: lines of 15 mm.
struct Foot {
  std::vector<CleanTriangle> triangles{{.corners = {0, 1, 2}, .triangle = 0}};
  std::vector<Vec3> positions{{0, 0, 0}, {9, 0, 0}, {0, 9, 0}};
  std::vector<ContactLine> lines;

  Foot() {
    for (int i = 0; i < sectors; ++i)
      lines.push_back({.on = 0, .other = 1, .ends = {Vec3d(on_circle(i)), Vec3d(on_circle(i + 1))}});
  }
  SizeField field(double max_edge) const { return {max_edge, lines, triangles, positions}; }
};

// An edge of this length, m, whose middle is on the outline.
std::array<Vec3, 2> across(float length, float height = 0.0f) {
  const auto middle = centre + Vec3(radius, 0.0f, height);
  return {middle - Vec3(0.5f * length, 0, 0), middle + Vec3(0.5f * length, 0, 0)};
}

bool is_too_long(const SizeField& field, const std::array<Vec3, 2>& edge) {
  return field.is_too_long(edge[0], edge[1]);
}

TEST(SizeField, edges_are_short_beside_many_short_lines_and_long_elsewhere) {
  const auto field = Foot().field(0.8);
  const auto [a, b] = across(0.3f);
  EXPECT_TRUE(field.is_too_long(a, b));
  EXPECT_TRUE(field.is_too_long(b, a)) << "in either order";
  EXPECT_FALSE(is_too_long(field, across(0.12f))) << "nine lines are nearer than 6 cm";
  const Vec3 far(4, 3, 0);
  EXPECT_FALSE(field.is_too_long(far, far + Vec3(0.79f, 0, 0)));
  EXPECT_TRUE(field.is_too_long(far, far + Vec3(0.81f, 0, 0)));
}

TEST(SizeField, lines_of_other_planes_and_edges_of_shadows_do_not_count) {
  Foot foot;
  EXPECT_FALSE(is_too_long(foot.field(0.8), across(0.3f, 0.01f)));
  for (auto& line : foot.lines) line.other = none;
  EXPECT_FALSE(is_too_long(foot.field(0.8), across(0.3f)));
}

TEST(SizeField, no_limit_means_none) {
  EXPECT_FALSE(Foot().field(0.0).is_too_long(centre, centre + Vec3(100, 0, 0)));
}

// Without the field needles are 0.66 m long.
TEST(SizeField, a_round_foot_leaves_no_long_needles_on_the_floor) {
  truth::SceneBuilder b;
  b.material("floor", 0.5f, 1.0f).quad({0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0});
  b.material("foot", 0.5f, 0.0f);
  for (int i = 0; i < sectors; ++i)
    b.quad(on_circle(i), on_circle(i + 1), on_circle(i + 1) + Vec3(0, 0, 0.5f),
           on_circle(i) + Vec3(0, 0, 0.5f));
  const auto patches = make_patches(b.scene(), {.max_edge = 0.8f});
  float longest = 0.0f;  // of patches with a line of the outline as an edge
  for (std::size_t p = 0; p < patches.size(); ++p) {
    if (patches.normal[p].z < 0.99f) continue;
    const auto c = patches.points(p);
    for (std::size_t k = 0; k < 3; ++k)
      if (glm::distance(c[k], c[(k + 1) % 3]) < 1.05f * glm::distance(on_circle(0), on_circle(1)))
        longest = std::max(longest, glm::distance(c[(k + 2) % 3], c[k]));
  }
  EXPECT_GT(longest, 0.02f);
  EXPECT_LT(longest, 0.3f);
}

}  // namespace
}  // namespace luxel
