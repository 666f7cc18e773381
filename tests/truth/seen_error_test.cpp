// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <gtest/gtest.h>

#include "luxel/patch/make_patches.h"
#include "luxel/solve/sampled.h"
#include "luxel/solve/seen_solution.h"

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
  const Workers workers(2);
  const Tracer tracer(s.patches, workers);
  s.report = solve_sampled(s.patches, tracer, s.solution, options, workers);
  s.recomputed = seen_error_of(s.patches, tracer, s.solution, workers);
  return s;
}

// Walls that reflect nothing, but for the lamp above.
Scene black_room() {
  const truth::Wall wall{0.0f, 0.0f};
  return truth::cube({wall, truth::Wall{0.0f, 1.0f}, wall, wall, wall, wall}, 3.0f);
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

// Several seeds share one measure, so the differences between their runs are those of the light alone: they
// must agree with what each of them states.
TEST(SeenErrorOfASolve, is_alike_for_all_seeds) {
  double least = 1.0, most = 0.0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const auto s = solve(truth::l_room(), {.error = 0.0, .rays = 1u << 22, .seed = seed});
    least = std::min(least, s.report.seen_error);
    most = std::max(most, s.report.seen_error);
  }
  EXPECT_LT(most / least, 1.3);
}

}  // namespace
}  // namespace luxel
