// SPDX-License-Identifier: Apache-2.0
// Pictures that are known: of a furnace, which is one colour; and the same room by paths and by a final
// gather.
#include "luxel/render/path_picture.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "luxel/core/error.h"
#include "luxel/patch/make_patches.h"
#include "luxel/render/final_gather.h"
#include "luxel/solve/sampled.h"

#include "support/truth_scenes.h"

namespace luxel {
namespace {

constexpr PictureSize small = {24, 18};
const Camera inside = {.eye = {0.1f, 0.15f, 0.2f}, .target = {0.9f, 0.8f, 0.6f}, .up = {0.0f, 0.0f, 1.0f}};

PathPicture trace(const PatchSet& patches, const PathOptions& options, const Camera& camera = inside,
                  int threads = 0) {
  const Context context(threads);
  const Tracer tracer(patches, context);
  return trace_picture(patches, tracer, camera, small, options, context);
}

// Sum of z² over pixels, green: each expected alike, or as another picture with errors of its own.
double mean_z2(const PathPicture& picture, const Vec3& expected) {
  double z2 = 0.0;
  for (std::size_t i = 0; i < picture.radiance.pixels.size(); ++i) {
    const auto z = (picture.radiance.pixels[i].g - expected.g) / picture.standard_error.pixels[i].g;
    z2 += static_cast<double>(z) * static_cast<double>(z);
  }
  return z2 / static_cast<double>(picture.radiance.pixels.size());
}

// All surfaces emit 1 - reflectance, so that radiosity is 1 and radiance 1 / pi, wherever one looks. The mean
// of z² over 432 pixels has a standard deviation of 0.07; a thousandth risk is five of them, and less where
// bars are a little wide.
TEST(PathPicture, of_a_furnace_is_one_colour_within_its_error_bars) {
  const auto patches = make_patches(truth::furnace(Vec3(0.7f), Vec3(0.3f)), {.max_edge = 0.5f});
  const auto glow = Vec3(1.0f / pi);
  for (const auto from : {BouncesFrom::points, BouncesFrom::patches}) {
    const auto picture = trace(patches, {.limits = {.samples = 512}, .bounces_from = from});
    EXPECT_TRUE(picture.complete);
    EXPECT_EQ(picture.paths, 512u);
    EXPECT_LT(mean_z2(picture, glow), 1.35);
    EXPECT_GT(mean_z2(picture, glow), 0.6);
    const auto mean = mean_color(picture.radiance);
    EXPECT_NEAR(mean.g, glow.g, 0.005f * glow.g);
    for (const auto& pixel : picture.radiance.pixels) EXPECT_NEAR(pixel.g, glow.g, 0.2f * glow.g);
  }
}

TEST(PathPicture, stops_at_the_error_asked_for) {
  const auto patches = make_patches(truth::cube_a(), {.max_edge = no_max_edge});
  const auto picture = trace(patches, {.limits = {.error = 0.05}});
  EXPECT_EQ(picture.stop, StopReason::error_reached);
  EXPECT_LE(picture.error, 0.05);
  EXPECT_GT(picture.error, 0.02);
}

TEST(PathPicture, is_the_same_on_any_number_of_threads_and_another_with_another_seed) {
  const auto patches = make_patches(truth::cube_a(), {.max_edge = no_max_edge});
  const auto one = trace(patches, {.limits = {.samples = 64}}, inside, 1);
  const auto five = trace(patches, {.limits = {.samples = 64}}, inside, 5);
  const auto other = trace(patches, {.limits = {.samples = 64}, .seed = 2}, inside, 5);
  EXPECT_EQ(one.radiance.pixels, five.radiance.pixels);
  EXPECT_EQ(one.standard_error.pixels, five.standard_error.pixels);
  EXPECT_NE(one.radiance.pixels, other.radiance.pixels);
}

// A camera that sees the lamp's front, its back, and a one-sided back.
TEST(PathPicture, shows_emission_from_the_front_alone_and_black_one_sided_backs) {
  truth::SceneBuilder b;
  b.material("lamp", 0.0f, 2.0f).quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
  b.material("sheet", 0.5f, 0.0f, false).quad({0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1});
  const auto patches = make_patches(b.scene(), {.max_edge = no_max_edge});
  const Vec3 middle(0.5f, 0.45f, 0.5f);
  const auto look = [&](const Vec3& eye, const Vec3& target) {
    const auto picture =
        trace(patches, {.limits = {.samples = 32}},
              {.eye = eye, .target = target, .up = {0.0f, 1.0f, 0.0f}, .vertical_fov = 20.0f});
    return picture.radiance.at(small.width / 2, small.height / 2).g;
  };
  EXPECT_NEAR(look(middle, {0.5f, 0.45f, 0.0f}), 2.0 / std::numbers::pi, 1e-5) << "front of the lamp";
  EXPECT_EQ(look({0.5f, 0.45f, -1.0f}, middle), 0.0f) << "back of the lamp";
  EXPECT_EQ(look(middle, {0.5f, 0.45f, 1.0f}), 0.0f) << "back of the sheet, in full light";
}

TEST(FinalGather, agrees_with_paths_and_counts_lamps_once) {
  const auto patches = make_patches(truth::cube_a(), {.max_edge = 0.1f});
  const Context context;
  const Tracer tracer(patches, context);
  Solution solution;
  solve_sampled(patches, tracer, solution, {.error = 0.005, .error_measure = ErrorMeasure::power}, context);
  const auto gathered = gather_picture(patches, solution, tracer, inside,
                                       {.width = small.width, .height = small.height, .rays = 400}, context);
  const auto traced = trace(patches, {.limits = {.samples = 1024}});
  double difference = 0.0;
  double square = 0.0;
  double light = 0.0;
  for (std::size_t i = 0; i < gathered.pixels.size(); ++i) {
    const double a = traced.radiance.pixels[i].g;
    const double b = gathered.pixels[i].g;
    difference += b - a;
    square += (b - a) * (b - a);
    light += a;
  }
  EXPECT_NEAR(difference / light, 0.0, 0.01);
  EXPECT_LT(std::sqrt(square * 432.0) / light, 0.04) << "relative RMS";
}

TEST(FinalGather, of_a_furnace_is_one_colour) {
  const auto patches = make_patches(truth::furnace(Vec3(0.7f), Vec3(0.3f)), {.max_edge = 0.5f});
  const Context context;
  const Tracer tracer(patches, context);
  Solution solution;  // the exact one
  solution.bands = patches.bands;
  solution.radiosity.front.assign(3 * patches.size(), 1.0f);
  solution.radiosity.back.assign(3 * patches.size(), 0.0f);
  const auto picture = gather_picture(patches, solution, tracer, inside,
                                      {.width = small.width, .height = small.height, .rays = 256}, context);
  EXPECT_NEAR(mean_color(picture).g, 1.0f / pi, 0.003f / pi);
  for (const auto& pixel : picture.pixels) EXPECT_NEAR(pixel.g, 1.0f / pi, 0.1f / pi);
  solution.radiosity.front.pop_back();
  EXPECT_THROW(gather_picture(patches, solution, tracer, inside, {}, context), MismatchError);
}

TEST(FinalGather, takes_at_least_the_rays_asked_for) {
  EXPECT_EQ(gather_grid(1), 1u);
  EXPECT_EQ(gather_grid(64), 8u);
  EXPECT_EQ(gather_grid(65), 9u);
}

}  // namespace
}  // namespace luxel
