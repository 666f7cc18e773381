// SPDX-License-Identifier: Apache-2.0
// Transmittance of panes along rays.
#include "luxel/trace/panes.h"

#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "luxel/core/address.h"
#include "luxel/core/warp.h"
#include "luxel/patch/make_patches.h"
#include "luxel/scene/glass.h"

#include "support/glass_panes.h"

namespace luxel {
namespace {

constexpr auto endless = std::numeric_limits<float>::infinity();
using truth::SceneBuilder;

// A floor, for there must be a patch, and glass.
SceneBuilder floor_and_glass() {
  SceneBuilder builder;
  builder.material("floor", 0.5f, 0.0f).quad({-9, -9, -9}, {9, -9, -9}, {9, 9, -9}, {-9, 9, -9});
  builder.material("glass", 0.1f, 0.0f);
  return builder;
}

Panes panes_of(const SceneBuilder& builder, const Vec3& transmittance) {
  auto scene = builder.scene();
  truth::make_pane(scene, "glass", transmittance);
  return Panes(make_patches(scene, {.max_edge = no_max_edge}));
}

std::vector<double> through(const Panes& panes, const Ray& ray, float distance = endless) {
  const auto found = panes.along(ray, distance);
  return {in_band(found, 0), in_band(found, 1), in_band(found, 2)};
}

double luminous(const Panes& panes, const Ray& ray, float distance = endless) {
  return panes.luminous(panes.along(ray, distance));
}

Ray ray_of(const Vec3& from, const Vec3& to) { return {from, glm::normalize(to - from)}; }

TEST(Panes, without_glass_all_light_passes) {
  const auto panes = panes_of(floor_and_glass(), Vec3(0.8f));
  EXPECT_TRUE(panes.empty());
  EXPECT_EQ(through(panes, ray_of({0, 0, 0}, {1, 1, 1})), (std::vector<double>{1.0, 1.0, 1.0}));
  EXPECT_EQ(luminous(panes, ray_of({0, 0, 0}, {1, 1, 1})), 1.0);
}

TEST(Panes, a_sheet_has_the_closed_form_at_every_angle_and_ends_where_the_ray_ends) {
  auto builder = floor_and_glass();
  builder.quad({-50, 0, -50}, {50, 0, -50}, {50, 0, 50}, {-50, 0, 50});
  const auto panes = panes_of(builder, Vec3(0.5f, 0.7f, 0.95f));
  EXPECT_TRUE(panes.is_tinted());
  for (std::uint64_t i = 0; i < 1000; ++i) {
    const auto u = uniform4(stream_key(3, 0, 0), i);
    const auto d = uniform_hemisphere(u[0], u[1]);
    if (d.z < 0.05f) continue;
    const Ray ray{{u[2], -1.0f, u[3]}, {d.x, d.z, d.y}};
    const auto cosine = static_cast<double>(d.z);
    const auto found = through(panes, ray);
    EXPECT_NEAR(found[0], pane_transmittance(0.5, cosine), 1e-5);
    EXPECT_NEAR(found[1], pane_transmittance(0.7, cosine), 1e-5);
    EXPECT_NEAR(found[2], pane_transmittance(0.95, cosine), 1e-5);
    EXPECT_NEAR(luminous(panes, ray), 0.2126 * found[0] + 0.7152 * found[1] + 0.0722 * found[2], 1e-6);
    EXPECT_EQ(through(panes, ray, 0.99f / d.z), (std::vector<double>{1.0, 1.0, 1.0}));
  }
}

TEST(Panes, a_ray_and_its_reverse_see_the_same) {
  auto builder = floor_and_glass();
  truth::add_box(builder, {-1, 0, -1}, {1, 0.01f, 1});
  truth::add_box(builder, {-1, 0.5f, -1}, {1, 0.7f, 1});
  builder.quad({-1, 1, -1}, {1, 1, -1}, {1, 1, 1}, {-1, 1, 1});
  const auto panes = panes_of(builder, Vec3(0.8f));
  for (std::uint64_t i = 0; i < 2000; ++i) {
    const auto u = uniform4(stream_key(5, 0, 0), 2 * i), v = uniform4(stream_key(5, 0, 0), 2 * i + 1);
    const Vec3 a(3.0f * u[0] - 1.5f, -1.0f - u[2], 3.0f * u[1] - 1.5f);
    const Vec3 b(3.0f * v[0] - 1.5f, 2.0f + v[2], 3.0f * v[1] - 1.5f);
    const auto length = glm::distance(a, b);
    EXPECT_NEAR(luminous(panes, ray_of(a, b), length), luminous(panes, ray_of(b, a), length), 1e-5);
  }
}

// Through the faces of a box, also where the ray enters or leaves by a narrow side.
TEST(Panes, a_box_counts_once_whichever_faces_the_ray_crosses) {
  auto builder = floor_and_glass();
  truth::add_box(builder, {-1, 0, -1}, {1, 0.1f, 1});
  const auto panes = panes_of(builder, Vec3(0.8f));
  const auto expect = [&](const Ray& ray) {
    EXPECT_NEAR(luminous(panes, ray),
                pane_transmittance(0.8, std::fabs(static_cast<double>(ray.direction.y))), 1e-5);
  };
  expect({{0.1f, -1, 0.2f}, {0, 1, 0}});
  expect(ray_of({0.3f, -1, 0.2f}, {-0.2f, 1, -0.3f}));
  expect(ray_of({0.85f, -0.05f, 0.2f}, {1.15f, 0.1f, 0.2f}));  // out by a narrow side
  expect(ray_of({-2, 0.02f, 0.2f}, {2, 0.08f, 0.1f}));         // in and out by narrow sides
}

TEST(Panes, a_ray_through_the_common_edge_of_two_triangles_counts_once) {
  auto builder = floor_and_glass();
  builder.quad({-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1});
  const auto panes = panes_of(builder, Vec3(0.8f));
  for (const float x : {-0.5f, -0.25f, 0.0f, 0.5f})
    EXPECT_NEAR(luminous(panes, {{x, -1, x}, {0, 1, 0}}), 0.8, 1e-6) << x;
}

TEST(Panes, panes_behind_each_other_multiply) {
  auto builder = floor_and_glass();
  for (int i = 0; i < 5; ++i) {
    const auto y = 0.02f * static_cast<float>(i);
    builder.quad({-1, y, -1}, {1, y, -1}, {1, y, 1}, {-1, y, 1});
  }
  const auto panes = panes_of(builder, Vec3(0.8f));
  EXPECT_NEAR(luminous(panes, {{0.1f, -1, 0.3f}, {0, 1, 0}}), std::pow(0.8, 5), 1e-6);
  EXPECT_NEAR(luminous(panes, {{0.1f, -1, 0.3f}, {0, 1, 0}}, 1.05f), std::pow(0.8, 3), 1e-6);
}

TEST(Panes, weights_of_bands_sum_to_one) {
  auto builder = floor_and_glass();
  builder.quad({-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1});
  auto scene = builder.scene();
  truth::make_pane(scene, "glass", Vec3(0.5f, 0.7f, 0.6f));
  for (double nm = 400.0; nm <= 700.0; nm += 20.0) scene.wavelengths.push_back(nm);
  const auto patches = make_patches(scene, {.max_edge = no_max_edge});
  const Panes panes(patches);
  const auto weights = panes.weights();
  ASSERT_EQ(weights.size(), 16u);
  EXPECT_NEAR(std::accumulate(weights.begin(), weights.end(), 0.0), 1.0, 1e-12);
  EXPECT_GT(weights[0], 0.005);
  const auto seen = panes.along({{0.1f, -1, 0.3f}, {0, 1, 0}}, endless);
  ASSERT_EQ(seen.size(), 16u);
  EXPECT_GT(seen[8], seen[0]);  // 560 nm, where green is
  EXPECT_GT(seen[8], seen[15]);
}

}  // namespace
}  // namespace luxel
