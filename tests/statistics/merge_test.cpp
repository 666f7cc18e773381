// SPDX-License-Identifier: Apache-2.0
// Merged runs: the mean weighted by rays, errors that are right, and refusals.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "luxel/core/error.h"
#include "luxel/solution/merge_solutions.h"
#include "luxel/solve/sampled.h"

#include "support/error_bars.h"
#include "support/known_rooms.h"
#include "support/sample_solution.h"

namespace luxel {
namespace {

NamedSolution run(const truth::KnownRoom& room, std::uint64_t seed, double error = 0.03) {
  const Context context;
  const Tracer tracer(room.patches, context);
  NamedSolution result{"seed " + std::to_string(seed), {room.patches, {}}};
  solve_sampled(room.patches, tracer, result.baked.solution,
                {.error = error, .error_measure = ErrorMeasure::power, .seed = seed}, context);
  return result;
}

TEST(Merge, of_four_runs_has_about_half_the_error_and_says_so) {
  // Eight merges of four runs each, of other seeds: the mean of their scores is judged as in error_bar_test,
  // with three standard errors (risk 0.02 each by Student's t with seven degrees of freedom;
  // measured far inside).
  for (const auto& room : {truth::coloured_room(), truth::hung_plate()}) {
    std::vector<Solution> merged;
    double single = 0.0;
    for (std::uint64_t m = 0; m < 8; ++m) {
      std::vector<NamedSolution> runs;
      for (std::uint64_t s = 1; s <= 4; ++s) runs.push_back(run(room, 4 * m + s));
      single += runs[0].baked.solution.predicted_error / 8.0;
      merged.push_back(merge_solutions(runs).solution);
    }
    double together = 0.0;
    for (const auto& s : merged) together += s.predicted_error / 8.0;
    EXPECT_NEAR(together / single, 0.5, 0.1) << room.name;
    EXPECT_NEAR(merged[0].error_degrees_of_freedom, 28.0, 3.0);
    const auto verdict = truth::judge(room, merged);
    EXPECT_NEAR(verdict.ratio.value, 1.0, 0.1 + 3.0 * verdict.ratio.standard_error) << room.name;
    EXPECT_GT(verdict.coverage.value, 0.92 - 3.0 * verdict.coverage.standard_error) << room.name;
    EXPECT_LT(verdict.coverage.value, 0.97 + 3.0 * verdict.coverage.standard_error) << room.name;
  }
}

TEST(Merge, in_any_order_gives_the_same_bytes_and_weighs_by_rays) {
  const auto room = truth::coloured_room();
  std::vector<NamedSolution> runs = {run(room, 1, 0.1), run(room, 2, 0.02), run(room, 3, 0.05)};
  const auto merged = merge_solutions(runs);
  std::vector<std::size_t> order = {0, 1, 2};
  do {
    const auto other = merge_solutions({runs[order[0]], runs[order[1]], runs[order[2]]});
    EXPECT_EQ(sample::difference(merged.solution, other.solution), "");
  } while (std::next_permutation(order.begin(), order.end()));
  double rays = 0.0;
  for (const auto& r : runs) rays += static_cast<double>(r.baked.solution.provenance.rays);
  for (const std::size_t i : {0u, 100u, 301u}) {
    double mean = 0.0;
    for (const auto& r : runs)
      mean += static_cast<double>(r.baked.solution.provenance.rays) / rays *
              static_cast<double>(r.baked.solution.irradiance.front[i]);
    EXPECT_NEAR(merged.solution.irradiance.front[i], mean, 1e-6 * mean);
  }
  EXPECT_EQ(merged.solution.provenance.merged.size(), 3u);
  EXPECT_EQ(static_cast<double>(merged.solution.provenance.rays), rays);
  // A merged solution can be merged again, but not with a part of itself.
  const auto more = merge_solutions({{"merged", merged}, run(room, 9)});
  EXPECT_EQ(more.solution.provenance.merged.size(), 4u);
  EXPECT_THROW(merge_solutions({{"merged", merged}, runs[1]}), InputError);
}

TEST(Merge, bias_of_sharing_is_not_taken_to_cancel) {
  auto sample = sample::baked_with_errors(3, 3);
  auto& s = sample.solution;
  for (auto* array : {&s.standard_error.front, &s.standard_error.back})
    std::fill(array->begin(), array->end(), 0.0f);
  for (auto* array : {&s.smoothing_bias.front, &s.smoothing_bias.back})
    std::fill(array->begin(), array->end(), 2.0f);
  s.error_degrees_of_freedom = 1e9;  // no widening
  std::fill(s.standard_error.front.begin(), s.standard_error.front.end(), std::sqrt(4.0f + 9.0f));
  std::fill(s.standard_error.back.begin(), s.standard_error.back.end(), 2.0f);
  auto other = sample;
  other.solution.provenance.seed = 8;
  const auto merged = merge_solutions({{"a", sample}, {"b", other}}).solution;
  EXPECT_NEAR(merged.standard_error.front[0], std::sqrt(4.0 + 9.0 / 2.0), 1e-5);
  EXPECT_NEAR(merged.standard_error.back[0], 2.0, 1e-5);
  EXPECT_EQ(merged.smoothing_bias.front[0], 2.0f);
}

std::string complaint(const std::vector<NamedSolution>& solutions) {
  try {
    merge_solutions(solutions);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(Merge, refuses_what_does_not_belong_together_by_name) {
  const auto a = NamedSolution{"a.vtkhdf", sample::baked_with_errors(4, 3)};
  auto b = a;
  b.name = "b.vtkhdf";
  EXPECT_NE(complaint({a}), "");
  EXPECT_EQ(complaint({a, b}),
            "b.vtkhdf: it is made with seed 7, as is a.vtkhdf: they are not independent, give each run a "
            "seed of its own");
  b.baked.solution.provenance.seed = 8;
  EXPECT_EQ(complaint({a, b}), "");
  auto other_scene = b;
  other_scene.baked.patches.scene_fingerprint += 1;
  EXPECT_EQ(complaint({a, other_scene}), "b.vtkhdf: it is of another scene than a.vtkhdf");
  auto repainted = b;
  repainted.baked.patches.materials[0].reflectance[0] = 0.1f;
  EXPECT_EQ(complaint({a, repainted}), "b.vtkhdf: it is of another scene than a.vtkhdf");
  const auto finer = NamedSolution{"b.vtkhdf", sample::baked_with_errors(5, 3)};
  EXPECT_NE(complaint({a, finer}).find("but of other patches"), std::string::npos);
  auto shot = b;
  shot.baked.solution.provenance.method = "stochastic-jacobi";
  EXPECT_NE(complaint({a, shot}).find("the sampled method"), std::string::npos);
}

}  // namespace
}  // namespace luxel
