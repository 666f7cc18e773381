// SPDX-License-Identifier: Apache-2.0
// Comparison of the solver with path tracing, which detects a wrong solver. Seeds are fixed. The solver's
// errors of different sides are not independent, so z² varies more than chi-square says: the limits are those
// that `luxel compare` has.
#include <gtest/gtest.h>

#include "luxel/patch/make_patches.h"
#include "luxel/render/compare.h"
#include "luxel/render/path_traced.h"
#include "luxel/solve/sampled.h"

#include "support/known_rooms.h"
#include "support/window_rooms.h"

namespace luxel {
namespace {

struct Both {
  Baked traced, solved;
};

Both both(const truth::KnownRoom& room, double error) {
  const Context context;
  const Tracer tracer(room.patches, context);
  Both both{{room.patches, {}}, {room.patches, {}}};
  trace_light(room.patches, tracer, both.traced.solution,
              {.limits = {.error = error}, .bounces_from = BouncesFrom::patches}, context);
  solve_sampled(room.patches, tracer, both.solved.solution,
                {.error = error, .error_measure = ErrorMeasure::power}, context);
  return both;
}

class SolverAndPaths : public testing::TestWithParam<truth::RoomMaker> {};

TEST_P(SolverAndPaths, agree_within_their_errors) {
  const auto room = GetParam().make();
  const auto [traced, solved] = both(room, 0.03);
  const auto c = compare_solutions(traced, solved);
  EXPECT_TRUE(c.agrees().value()) << "mean z² " << c.mean_z2 << ", within " << c.within;
  EXPECT_LT(c.relative_rms, 0.05);
  EXPECT_LT(std::abs(c.mean_bias), 0.01);
}

INSTANTIATE_TEST_SUITE_P(Every, SolverAndPaths, testing::ValuesIn(truth::known_rooms()),
                         [](const testing::TestParamInfo<truth::RoomMaker>& one) { return one.param.name; });

// All light two per cent too bright, as by a forgotten factor.
TEST(Compare, finds_a_solver_out_that_is_wrong_by_two_per_cent) {
  auto [traced, solved] = both(truth::luminous_ceiling(), 0.02);
  EXPECT_TRUE(compare_solutions(traced, solved).agrees().value());
  for (auto& H : solved.solution.irradiance.front) H *= 1.02f;
  const auto c = compare_solutions(traced, solved);
  EXPECT_FALSE(c.agrees().value()) << "mean z² " << c.mean_z2 << ", within " << c.within;
  EXPECT_NEAR(c.mean_bias, 0.02, 0.003);
}

// One wall a tenth too dark: few sides, which the list names.
TEST(Compare, says_where_a_solver_is_wrong) {
  auto [traced, solved] = both(truth::luminous_ceiling(), 0.02);
  for (std::size_t p = 0; p < solved.patches.size(); ++p)
    if (solved.patches.material_of(p).name == "floor")
      for (std::size_t b = 0; b < 3; ++b) solved.solution.irradiance.front[3 * p + b] *= 0.8f;
  const auto c = compare_solutions(traced, solved);
  EXPECT_FALSE(c.agrees().value());
  for (const auto& d : c.largest) EXPECT_EQ(solved.patches.material_of(d.index / 2).name, "floor");
}

// Portals change the noise of paths and not their light, also where one covers another or stands before it.
TEST(Reference, has_a_fifth_of_the_noise_with_portals_and_the_same_light) {
  const auto patches = make_patches(truth::under_sky(truth::window_room()), {.max_edge = 0.5f});
  const auto traced = [&](const std::vector<Portal>& portals, std::uint64_t seed) {
    Baked baked{patches, {}};
    baked.patches.portals = portals;
    const Tracer tracer(patches);
    const auto report =
        trace_light(baked.patches, tracer, baked.solution, {.limits = {.samples = 2048}, .seed = seed});
    return std::pair(std::move(baked), report.predicted_error);
  };
  const auto [without, noise] = traced({}, 1);
  auto several = truth::window_portals();
  for (const auto& more : {truth::window_portals(0.25f, true), truth::window_portals()})
    several.insert(several.end(), more.begin(), more.end());
  for (const auto& portals : {truth::window_portals(), several}) {
    const auto [with, reduced] = traced(portals, 2);
    const auto c = compare_solutions(with, without);
    EXPECT_TRUE(c.agrees().value()) << "mean z² " << c.mean_z2 << ", within " << c.within;
    EXPECT_LT(std::abs(c.mean_bias), 0.01);
    EXPECT_LT(reduced, 0.2 * noise);
  }
}

}  // namespace
}  // namespace luxel
