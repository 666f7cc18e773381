// SPDX-License-Identifier: Apache-2.0
// Patches joined to the polygons that hide: as few as can be, covering what the patches cover.
#include "luxel/form_factors/occluders.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "luxel/core/address.h"
#include "luxel/form_factors/polygon_form_factor.h"
#include "luxel/patch/make_patches.h"

#include "support/truth_scenes.h"

namespace luxel {
namespace {

constexpr double slack = 1e-6;

double area_of(const Occluders& occluders) {
  double sum = 0.0;
  for (std::size_t k = 0; k < occluders.size(); ++k)
    sum += glm::length(polygon_area_vector(occluders.polygon(k)));
  return sum;
}

double area_of(const PatchSet& patches) {
  double sum = 0.0;
  for (const auto area : patches.area) sum += static_cast<double>(area);
  return sum;
}

// Returns whether a point lies in the polygon, at least `margin`, m, inside its boundary.
bool is_inside(std::span<const Vec3d> polygon, const Vec3d& p, double margin) {
  const auto normal = glm::normalize(polygon_area_vector(polygon));
  if (std::fabs(glm::dot(normal, p - polygon[0])) > slack) return false;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const auto edge = polygon[(k + 1) % polygon.size()] - polygon[k];
    if (glm::dot(normal, glm::cross(glm::normalize(edge), p - polygon[k])) < margin) return false;
  }
  return true;
}

void expect_cover(const PatchSet& patches, const Occluders& occluders) {
  EXPECT_NEAR(area_of(occluders), area_of(patches), 1e-5 * area_of(patches));
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const Vec3d centre(patches.centroid(p));
    int covered = 0;
    for (std::size_t k = 0; k < occluders.size(); ++k)
      covered += is_inside(occluders.polygon(k), centre, -slack);
    EXPECT_EQ(covered, 1) << p;
  }
}

TEST(Occluders, walls_of_a_room_are_six_however_finely_they_are_cut) {
  for (const float max_edge : {no_max_edge, 0.6f, 0.21f, 0.1f}) {
    const auto patches = make_patches(truth::cube_a(), {.max_edge = max_edge});
    const Occluders occluders(patches, slack);
    EXPECT_EQ(occluders.size(), 6u) << max_edge << ": " << patches.size() << " patches";
    expect_cover(patches, occluders);
  }
}

TEST(Occluders, cover_rooms_with_blocks_and_balls) {
  for (const auto& scene : {truth::furnace(Vec3(0.5f), Vec3(0.5f)), truth::sphere(12, 0.5f)}) {
    const auto patches = make_patches(scene, {.max_edge = 0.3f});
    const Occluders occluders(patches, slack);
    EXPECT_LT(occluders.size(), patches.size());
    expect_cover(patches, occluders);
  }
}

// An L, and a square with a hole, are no convex polygons: nothing hides where there is nothing.
TEST(Occluders, leave_notches_and_holes_open) {
  truth::SceneBuilder b;
  b.material("m", 0.5f, 0.0f);
  const auto square = [&](float x, float y) {
    b.quad({x, y, 0}, {x + 1, y, 0}, {x + 1, y + 1, 0}, {x, y + 1, 0});
  };
  for (int x = 0; x < 3; ++x)
    for (int y = 0; y < 3; ++y)
      if (x != 1 || y != 1) square(static_cast<float>(x), static_cast<float>(y));
  for (const float max_edge : {no_max_edge, 0.3f}) {
    const auto patches = make_patches(b.scene(), {.max_edge = max_edge});
    const Occluders occluders(patches, slack);
    EXPECT_LE(occluders.size(), 8u);
    EXPECT_GE(occluders.size(), 4u);
    expect_cover(patches, occluders);
    for (std::size_t k = 0; k < occluders.size(); ++k)
      EXPECT_FALSE(is_inside(occluders.polygon(k), {1.5, 1.5, 0.0}, 0.0));
  }
}

// Two triangles on the same side of their common edge lie over each other; the square around both is not
// covered.
TEST(Occluders, do_not_join_what_lies_over_each_other) {
  truth::SceneBuilder b;
  b.material("m", 0.5f, 0.0f);
  b.triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}).triangle({0, 0, 0}, {1, 0, 0}, {1, 1, 0});
  const auto patches = make_patches(b.scene(), {});
  const Occluders occluders(patches, slack);
  for (std::size_t k = 0; k < occluders.size(); ++k)
    EXPECT_FALSE(is_inside(occluders.polygon(k), {0.5, 0.9, 0.0}, 0.0));
}

}  // namespace
}  // namespace luxel
