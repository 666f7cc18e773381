// SPDX-License-Identifier: Apache-2.0
// Which patches are one smooth surface: creases, windings, walls on floors.
#include <cmath>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

#include "luxel/surface/smooth_light.h"

#include "support/lit_patches.h"

namespace luxel {
namespace {

using test::LitPatches;
using test::plain_material;

float front(const SmoothLight& light, std::size_t patch, std::size_t corner) {
  return light.irradiance.front[3 * light.corners[patch][corner]];
}
float back(const SmoothLight& light, std::size_t patch, std::size_t corner) {
  return light.irradiance.back[3 * light.corners[patch][corner]];
}

// A unit cube, outward; face f has light f + 1 on both its triangles.
LitPatches cube() {
  LitPatches lit;
  for (int i = 0; i < 8; ++i) lit.vertex(Vec3(i & 1, (i >> 1) & 1, i >> 2));
  const std::array<std::array<std::uint32_t, 4>, 6> faces = {
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
  for (std::size_t f = 0; f < 6; ++f) {
    const auto& q = faces[f];
    lit.patch({q[0], q[1], q[2]}, static_cast<float>(f + 1));
    lit.patch({q[0], q[2], q[3]}, static_cast<float>(f + 1));
  }
  return lit;
}

TEST(SmoothSurfaces, each_corner_of_a_cube_is_three_surfaces_and_nothing_smears) {
  const auto lit = cube();
  const auto light = make_smooth_light(lit.patches, lit.solution);
  EXPECT_EQ(light.size(), 24u);
  for (std::size_t p = 0; p < lit.patches.size(); ++p)
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(front(light, p, k), static_cast<float>(p / 2 + 1));
      EXPECT_EQ(light.normal[light.corners[p][k]], lit.patches.normal[p]);
      EXPECT_EQ(light.vertex[light.corners[p][k]], lit.patches.corners[p][k]);
    }
}

TEST(SmoothSurfaces, a_cube_is_one_surface_where_no_angle_is_a_crease) {
  const auto lit = cube();
  EXPECT_EQ(make_smooth_light(lit.patches, lit.solution, {.crease_angle = 91.0f}).size(), 8u);
  EXPECT_EQ(make_smooth_light(lit.patches, lit.solution, {.crease_angle = 89.0f}).size(), 24u);
}

TEST(SmoothSurfaces, a_sphere_is_smooth_and_its_normals_point_outwards) {
  LitPatches lit;
  constexpr std::uint32_t rings = 12, slices = 24;
  const auto step = std::numbers::pi_v<float> / rings;
  const auto top = lit.vertex({0, 0, 1});
  for (std::uint32_t r = 1; r < rings; ++r)
    for (std::uint32_t s = 0; s < slices; ++s) {
      const auto theta = step * static_cast<float>(r), phi = step * static_cast<float>(s);
      lit.vertex({std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)});
    }
  const auto bottom = lit.vertex({0, 0, -1});
  const auto at = [](std::uint32_t r, std::uint32_t s) { return 1 + (r - 1) * slices + s % slices; };
  for (std::uint32_t s = 0; s < slices; ++s) {
    lit.patch({top, at(1, s), at(1, s + 1)}, 1.0f);
    lit.patch({bottom, at(rings - 1, s + 1), at(rings - 1, s)}, 1.0f);
    for (std::uint32_t r = 1; r + 1 < rings; ++r) {
      lit.patch({at(r, s), at(r + 1, s), at(r + 1, s + 1)}, 1.0f);
      lit.patch({at(r, s), at(r + 1, s + 1), at(r, s + 1)}, 1.0f);
    }
  }
  const auto light = make_smooth_light(lit.patches, lit.solution);
  ASSERT_EQ(light.size(), lit.patches.vertices.size());
  for (std::size_t s = 0; s < light.size(); ++s) {
    EXPECT_GT(glm::dot(light.normal[s], lit.patches.vertices[light.vertex[s]]), 0.99f);
    EXPECT_NEAR(glm::length(light.normal[s]), 1.0f, 1e-6f);
  }
}

// Two triangles of equal area in the plane z = 0 that share the edge a c; the second is wound the other way.
LitPatches flipped_strip(std::vector<BandMaterial> materials, std::uint32_t second_material) {
  LitPatches lit(std::move(materials));
  const auto a = lit.vertex({0, 0, 0}), b = lit.vertex({1, 0, 0}), c = lit.vertex({0, 1, 0}),
             d = lit.vertex({-1, 0, 0});
  lit.patch({a, b, c}, 2.0f, 10.0f, 0);
  lit.patch({a, d, c}, 20.0f, 4.0f, second_material);
  return lit;
}

TEST(SmoothSurfaces, a_flipped_neighbour_goes_on_with_its_back) {
  const auto lit = flipped_strip({plain_material("grey", 0.5f)}, 0);
  const auto light = make_smooth_light(lit.patches, lit.solution);
  ASSERT_EQ(light.size(), 6u);  // b, d, and two mirrored ones each at a and c
  EXPECT_NE(light.corners[0][0], light.corners[1][0]);
  EXPECT_EQ(front(light, 0, 0), 3.0f);   // (2 + 4) / 2
  EXPECT_EQ(back(light, 0, 0), 15.0f);   // (10 + 20) / 2
  EXPECT_EQ(front(light, 1, 0), 15.0f);  // the same, seen from the other side
  EXPECT_EQ(back(light, 1, 0), 3.0f);
  EXPECT_EQ(light.normal[light.corners[0][0]], Vec3(0, 0, 1));
  EXPECT_EQ(light.normal[light.corners[1][0]], Vec3(0, 0, -1));
  EXPECT_EQ(front(light, 0, 1), 2.0f);
  EXPECT_EQ(front(light, 1, 1), 20.0f);
}

TEST(SmoothSurfaces, the_back_of_a_one_sided_neighbour_has_no_say) {
  auto lit = flipped_strip({plain_material("grey", 0.5f), plain_material("sheet", 0.5f, false)}, 1);
  for (std::size_t band = 0; band < 3; ++band) lit.solution.irradiance.back[3 + band] = 0.0f;
  const auto light = make_smooth_light(lit.patches, lit.solution);
  EXPECT_EQ(front(light, 0, 0), 2.0f);  // not (2 + 0) / 2
  EXPECT_EQ(back(light, 0, 0), 15.0f);
  EXPECT_EQ(front(light, 1, 0), 15.0f);
}

TEST(SmoothSurfaces, a_fold_flat_on_itself_is_a_crease) {
  LitPatches lit;
  const auto a = lit.vertex({0, 0, 0}), b = lit.vertex({1, 0, 0}), c = lit.vertex({0, 1, 0}),
             d = lit.vertex({2, 0, 0});
  lit.patch({a, b, c}, 1.0f);
  lit.patch({a, d, c}, 5.0f);  // same normal, but doubled back over the first
  const auto light = make_smooth_light(lit.patches, lit.solution);
  EXPECT_EQ(front(light, 0, 0), 1.0f);
  EXPECT_EQ(front(light, 1, 0), 5.0f);
}

TEST(SmoothSurfaces, a_wall_parts_the_light_before_it_but_not_behind_the_floor) {
  LitPatches lit;
  const auto a = lit.vertex({0, 0, 0}), b = lit.vertex({0, 1, 0});
  const auto left = lit.vertex({-1, 0, 0}), right = lit.vertex({1, 0, 0}), up = lit.vertex({0, 0, 1});
  lit.patch({a, b, left}, 1.0f, 2.0f);   // floor, front upwards
  lit.patch({a, right, b}, 3.0f, 4.0f);  // floor, front upwards
  lit.patch({a, b, up}, 9.0f, 9.0f);     // the wall
  const auto light = make_smooth_light(lit.patches, lit.solution);
  EXPECT_EQ(front(light, 0, 0), 1.0f);
  EXPECT_EQ(front(light, 1, 0), 3.0f);
  EXPECT_EQ(back(light, 0, 0), 3.0f);  // (2 + 4) / 2
  EXPECT_EQ(back(light, 1, 0), 3.0f);
  EXPECT_EQ(front(light, 2, 0), 9.0f);
}

TEST(SmoothSurfaces, patches_that_meet_at_a_point_only_are_apart) {
  LitPatches lit;
  const auto o = lit.vertex({0, 0, 0});
  lit.patch({o, lit.vertex({1, 0, 0}), lit.vertex({1, 1, 0})}, 1.0f);
  lit.patch({o, lit.vertex({-1, 0, 0}), lit.vertex({-1, -1, 0})}, 5.0f);
  const auto light = make_smooth_light(lit.patches, lit.solution);
  EXPECT_EQ(front(light, 0, 0), 1.0f);
  EXPECT_EQ(front(light, 1, 0), 5.0f);
}

TEST(SmoothSurfaces, a_fan_with_random_windings_is_as_smooth_as_one_wound_alike) {
  LitPatches lit;
  const auto o = lit.vertex({0, 0, 0});
  constexpr std::uint32_t n = 6;
  for (std::uint32_t i = 0; i < n; ++i) {
    const auto phi = 2.0f * std::numbers::pi_v<float> * static_cast<float>(i) / n;
    lit.vertex({std::cos(phi), std::sin(phi), 0.0f});
  }
  const std::set<std::uint32_t> flipped = {1, 2, 5};
  for (std::uint32_t i = 0; i < n; ++i) {
    const auto p = 1 + i, q = 1 + (i + 1) % n;
    const auto above = static_cast<float>(i);
    if (flipped.contains(i))
      lit.patch({o, q, p}, 7.0f, above);
    else
      lit.patch({o, p, q}, above, 7.0f);
  }
  const auto light = make_smooth_light(lit.patches, lit.solution);
  EXPECT_EQ(light.size(), 2u + 4u * 2u + 2u);  // mirrored where windings meet: the middle and 4 of 6 rim ends
  for (std::uint32_t i = 0; i < n; ++i) {
    const auto above = flipped.contains(i) ? back(light, i, 0) : front(light, i, 0);
    const auto below = flipped.contains(i) ? front(light, i, 0) : back(light, i, 0);
    EXPECT_NEAR(above, 2.5f, 1e-6f);
    EXPECT_NEAR(below, 7.0f, 1e-6f);
  }
}

}  // namespace
}  // namespace luxel
