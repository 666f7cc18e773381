// SPDX-License-Identifier: Apache-2.0
// Light at the vertices of the file, against what least squares gives by hand.
#include "luxel/surface/vertex_fit.h"

#include <cmath>

#include <gtest/gtest.h>

#include "luxel/core/error.h"
#include "luxel/patch/make_patches.h"

#include "support/lightmap_scenes.h"
#include "support/linear_light.h"

namespace luxel {
namespace {

using test::even_light;
using test::linear_back;
using test::linear_front;
using test::linear_light;

Scene floor_and_wall() {
  truth::SceneBuilder b;
  b.material("grey", 0.5f, 0.0f);
  b.quad({0, 0, 0}, {2, 0, 0}, {2, 3, 0}, {0, 3, 0});
  b.quad({0, 3, 0}, {2, 3, 0}, {2, 3, 2}, {0, 3, 2});
  return b.scene();
}

TEST(VertexFit, linear_light_is_fitted_exactly_on_both_sides) {
  const auto scene = floor_and_wall();
  const auto patches = make_patches(scene, {.max_edge = 0.3f});
  ASSERT_GT(patches.size(), 100u);
  const auto fit = fit_vertices(scene, patches, make_smooth_light(patches, linear_light(patches)));
  ASSERT_EQ(fit.irradiance.front.size(), 3 * scene.positions.size());
  for (std::size_t v = 0; v < scene.positions.size(); ++v)
    for (std::size_t b = 0; b < 3; ++b) {
      EXPECT_NEAR(fit.irradiance.front[3 * v + b], linear_front(scene.positions[v]), 2e-4f);
      EXPECT_NEAR(fit.irradiance.back[3 * v + b], linear_back(scene.positions[v]), 2e-4f);
    }
  EXPECT_LT(fit.difference, 1e-4);
}

// One triangle, of which a part is lit: x with M x = w, by hand. The corners' hats integrate against a step
// that patches have as their means; smooth light of a crease angle of 0 keeps these as they are.
TEST(VertexFit, is_the_least_squares_answer) {
  truth::SceneBuilder b;
  b.material("grey", 0.5f, 0.0f);
  b.triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  const auto scene = b.scene();
  const auto patches = make_patches(scene, {.max_edge = 0.2f});
  auto light = even_light(patches, 1.0f);
  for (std::size_t p = 0; p < patches.size(); ++p)
    for (std::size_t band = 0; band < 3; ++band)
      light.irradiance.front[3 * p + band] = 1.0f + patches.centroid(p).x * patches.centroid(p).x;
  const auto fit = fit_vertices(scene, patches, make_smooth_light(patches, light, {.crease_angle = 0.0f}));
  Vec3d wanted(0.0);
  double least = 2.0;
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const auto c = Vec3d(patches.centroid(p));
    const Vec3d hats(1.0 - c.x - c.y, c.x, c.y);  // linear: their means are those at the centroid
    least = std::min(least, static_cast<double>(light.irradiance.front[3 * p]));
    wanted += static_cast<double>(patches.area[p] * light.irradiance.front[3 * p]) * hats;
  }
  // The inverse of A/12 (I + 1 1^T) is 12/A (I - 1 1^T / 4).
  const auto expected = 24.0 * (wanted - Vec3d(0.25 * (wanted.x + wanted.y + wanted.z)));
  for (std::size_t v = 0; v < 3; ++v) {
    const auto& at = scene.positions[v];
    const auto hat = at.x > 0.5f ? 1 : at.y > 0.5f ? 2 : 0;
    EXPECT_NEAR(fit.irradiance.front[3 * v], std::max(expected[hat], least), 1e-5);
  }
}

TEST(VertexFit, stays_within_the_light_there_is) {
  const auto scene = floor_and_wall();
  const auto patches = make_patches(scene, {.max_edge = 0.1f});
  auto light = even_light(patches, 0.0f);
  for (std::size_t p = 0; p < patches.size(); ++p)  // a bright spot in a corner
    if (glm::length(patches.centroid(p)) < 0.4f)
      for (std::size_t b = 0; b < 3; ++b) light.irradiance.front[3 * p + b] = 10.0f;
  const auto fit = fit_vertices(scene, patches, make_smooth_light(patches, light));
  for (const auto value : fit.irradiance.front) {
    EXPECT_GE(value, 0.0f);
    EXPECT_LE(value, 10.5f);
  }
  EXPECT_GT(fit.difference, 0.3) << "four corners cannot show it, and that is said";
}

// A file that splits a vertex for its texture does not split the light.
TEST(VertexFit, vertices_at_one_place_of_one_surface_have_one_value) {
  truth::SceneBuilder b;
  b.material("grey", 0.5f, 0.0f);
  b.quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}).quad({1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0});
  const auto scene = b.scene();
  const auto patches = make_patches(scene, {.max_edge = 0.2f});
  auto light = even_light(patches, 1.0f);
  for (std::size_t p = 0; p < patches.size(); ++p)
    for (std::size_t band = 0; band < 3; ++band)
      light.irradiance.front[3 * p + band] = 1.0f + std::pow(patches.centroid(p).x, 3.0f);
  const auto fit = fit_vertices(scene, patches, make_smooth_light(patches, light));
  int pairs = 0;
  for (std::size_t v = 0; v < scene.positions.size(); ++v)
    for (std::size_t w = 0; w < v; ++w)
      if (scene.positions[v] == scene.positions[w]) {
        EXPECT_EQ(fit.irradiance.front[3 * v], fit.irradiance.front[3 * w]);
        ++pairs;
      }
  EXPECT_GE(pairs, 2);
}

TEST(VertexFit, light_of_another_scene_is_refused) {
  const auto patches = make_patches(floor_and_wall(), {.max_edge = 0.5f});
  truth::SceneBuilder b;
  b.material("grey", 0.5f, 0.0f);
  b.triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  EXPECT_THROW(fit_vertices(b.scene(), patches, make_smooth_light(patches, linear_light(patches))),
               MismatchError);
}

}  // namespace
}  // namespace luxel
