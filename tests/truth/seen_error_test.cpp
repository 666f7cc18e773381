// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "luxel/patch/make_patches.h"
#include "luxel/solve/sampled.h"
#include "luxel/solve/seen_measure.h"

#include "support/truth_scenes.h"

namespace luxel {
namespace {

struct Solved {
  PatchSet patches;
  Solution solution;
  SolveReport report;
  double recomputed = 0.0;
};

Solved solve(const Scene& scene, const SampledOptions& options) {
  Solved s{make_patches(scene, {.max_edge = 0.1f}), {}, {}, 0.0};
  const Context context(2);
  const Tracer tracer(s.patches, context);
  s.report = solve_sampled(s.patches, tracer, s.solution, options, context);
  s.recomputed = seen_error_of(s.patches, tracer, s.solution, context);
  return s;
}

// An L-shaped room that reflects nothing: round its corner the lamp is seen in part.
Scene black_room() {
  auto scene = truth::l_room();
  for (auto& material : scene.materials) material.reflectance = Vec3(0.0f);
  return scene;
}

TEST(SeenErrorOfASolve, ends_the_run_and_follows_from_the_solution) {
  const auto s = solve(truth::cube_a(), {.error = 0.01});
  EXPECT_EQ(s.report.stop, StopReason::error_reached);
  EXPECT_GT(s.report.seen_error, 0.0);
  EXPECT_LE(s.report.seen_error, 0.01);
  EXPECT_EQ(s.solution.seen_error, s.report.seen_error);
  EXPECT_NEAR(s.recomputed / s.report.seen_error, 1.0, 1e-3);
  EXPECT_GT(s.report.predicted_error, 0.0) << "the power-weighted one stands beside it";
}

TEST(SeenErrorOfASolve, is_not_known_where_the_power_ends_the_run) {
  const auto s = solve(truth::cube_a(), {.error = 0.02, .error_measure = ErrorMeasure::power});
  EXPECT_EQ(s.report.seen_error, 0.0);
  EXPECT_EQ(s.report.views, 0u);
  EXPECT_LE(s.report.predicted_error, 0.02);
  EXPECT_GT(s.recomputed, 0.0);
}

TEST(SeenErrorOfASolve, of_a_black_room_is_that_of_its_irradiance) {
  const auto s = solve(black_room(), {.error = 0.02});
  EXPECT_EQ(s.report.stop, StopReason::error_reached);
  EXPECT_GT(s.report.seen_error, 0.0);
  EXPECT_LE(s.report.seen_error, 0.02);
}

}  // namespace
}  // namespace luxel
