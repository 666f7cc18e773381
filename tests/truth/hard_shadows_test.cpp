// SPDX-License-Identifier: Apache-2.0
// Hard shadows of punctual lights: a step of the irradiance along a known line, in patches and in pictures.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "luxel/patch/make_patches.h"
#include "luxel/render/render.h"
#include "luxel/solve/bake.h"
#include "luxel/surface/smooth_light.h"

#include "support/truth_scenes.h"

namespace luxel {
namespace {

// A floor of 4 m x 4 m that reflects a half, and a black screen of 1 m x 1 m that floats 1 m above it, turned
// by about 17 degrees, so that its edges cross the patches of the floor. The screen absorbs what the floor
// reflects: the light of the floor is that of the sun alone.
const Vec3 side_x(0.96f, 0.28f, 0.0f), side_y(-0.28f, 0.96f, 0.0f);
constexpr double rise = 0.8;  // cosine of the sun on the floor

Scene floor_under_sun() {
  truth::SceneBuilder builder;
  builder.material("floor", 0.5f, 0.0f, false).quad({-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0});
  const Vec3 corner(-1.0f, -0.5f, 1.0f);
  builder.material("screen", 0.0f, 0.0f)
      .quad(corner, corner + side_x, corner + side_x + side_y, corner + side_y);
  auto scene = builder.scene();
  scene.up = {0, 0, 1};
  scene.point_lights = {{.name = "sun",
                         .kind = PointLightKind::directional,
                         .direction = {0.6f, 0.0f, -0.8f},
                         .intensity = Vec3(2.0f)}};
  return scene;
}

// m, above 0 inside of the shadow: the distance from its nearest edge.
double depth_in_shadow(const Vec3d& p) {
  const auto d = p - Vec3d(-1.0 + 0.75, -0.5, 0.0);
  const auto x = glm::dot(d, Vec3d(side_x)), y = glm::dot(d, Vec3d(side_y));
  return std::min({x, 1.0 - x, y, 1.0 - y});
}

Baked baked() {
  const BakeOptions options{.patches = {.max_edge = 0.3f},
                            .light = {.error = 0.01, .error_measure = ErrorMeasure::power}};
  return bake(floor_under_sun(), options, Context(2));
}

TEST(HardShadows, each_patch_is_lit_or_dark_and_the_areas_are_right) {
  const auto b = baked();
  double dark = 0.0;
  for (std::size_t p = 0; p < b.patches.size(); ++p) {
    if (b.patches.material_of(p).name != "floor") continue;
    const bool is_dark = depth_in_shadow(Vec3d(b.patches.centroid(p))) > 0.0;
    if (is_dark) dark += static_cast<double>(b.patches.area[p]);
    EXPECT_NEAR(b.solution.irradiance.front[3 * p], is_dark ? 0.0 : 2.0 * rise,
                1e-6 + 6.0 * b.solution.standard_error.front[3 * p]);
    for (const auto& corner : b.patches.points(p))
      EXPECT_TRUE(is_dark ? depth_in_shadow(Vec3d(corner)) > -1e-5 : depth_in_shadow(Vec3d(corner)) < 1e-5);
  }
  EXPECT_NEAR(dark, 1.0, 1e-5);
}

TEST(HardShadows, smooth_light_is_a_step_at_the_edge) {
  const auto b = baked();
  const auto smooth = make_smooth_light(b.patches, b.solution);
  for (std::size_t p = 0; p < b.patches.size(); ++p) {
    if (b.patches.material_of(p).name != "floor") continue;
    const bool is_dark = depth_in_shadow(Vec3d(b.patches.centroid(p))) > 0.0;
    for (const auto node : smooth.corners[p])
      EXPECT_NEAR(smooth.irradiance.front[3 * node], is_dark ? 0.0 : 2.0 * rise, 1e-3);
  }
}

// From below the screen, so that it hides nothing: pixels that the edge does not cross are right.
TEST(HardShadows, a_picture_has_a_step_within_a_pixel) {
  const auto b = baked();
  const Camera camera{.eye = {0, 0, 0.99f}, .target = {0, 0, 0}, .up = {0, 1, 0}, .vertical_fov = 90.0f};
  constexpr int size = 200;
  const auto picture = render(b, camera, {.width = size, .height = size}, Context(2));
  constexpr double pixel = 2.0 * 0.99 / size;  // m on the floor
  int lit = 0, dark = 0;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const Vec3d at((x + 0.5) * pixel - 0.99, 0.99 - (y + 0.5) * pixel, 0.0);
      const auto depth = depth_in_shadow(at);
      if (std::fabs(depth) < 0.75 * pixel) continue;
      (depth > 0.0 ? dark : lit) += 1;
      EXPECT_NEAR(picture.at(x, y).x, depth > 0.0 ? 0.0 : 0.5 / std::numbers::pi * 2.0 * rise, 1e-3);
    }
  EXPECT_GT(lit, 5000);
  EXPECT_GT(dark, 5000);
}

}  // namespace
}  // namespace luxel
