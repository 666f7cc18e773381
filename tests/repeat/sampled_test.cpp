// SPDX-License-Identifier: Apache-2.0
// The sampled solver gives the same bytes however it is run.
#include "luxel/solve/sampled.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "luxel/patch/make_patches.h"

#include "support/sample_solution.h"
#include "support/truth_scenes.h"

namespace luxel {
namespace {

struct Solved {
  Solution solution;
  SolveReport report;
};

Solved solve(const PatchSet& patches, const SampledOptions& options, int threads = 2,
             const Monitor& monitor = {}, const LightSink& on_light = {}) {
  const auto context = Context(threads).with_monitor(monitor);
  const Tracer tracer(patches, context);
  Solved solved;
  solved.report = solve_sampled(patches, tracer, solved.solution, options, {.on_light = on_light}, context);
  return solved;
}

PatchSet room() { return make_patches(truth::l_room(), {.max_edge = 0.2f}); }

// The first part of the light that differs, or nothing.
std::string difference_of_light(const Solution& a, const Solution& b) {
  if (!sample::same_bits(a.irradiance.front, b.irradiance.front)) return "irradiance_front";
  if (!sample::same_bits(a.irradiance.back, b.irradiance.back)) return "irradiance_back";
  if (!sample::same_bits(a.radiosity.front, b.radiosity.front)) return "radiosity_front";
  if (!sample::same_bits(a.radiosity.back, b.radiosity.back)) return "radiosity_back";
  if (!sample::same_bits(a.standard_error.front, b.standard_error.front)) return "standard_error_front";
  if (!sample::same_bits(a.standard_error.back, b.standard_error.back)) return "standard_error_back";
  if (a.unshot_fraction != b.unshot_fraction) return "unshot_fraction";
  if (a.predicted_error != b.predicted_error) return "predicted_error";
  if (a.error_95th != b.error_95th) return "error_95th";
  return a.provenance.rays == b.provenance.rays ? "" : "rays";
}

// Compares the further numbers of the report.
void expect_same_report(const SolveReport& a, const SolveReport& b) {
  EXPECT_EQ(a.energy.emitted, b.energy.emitted);
  EXPECT_EQ(a.energy.absorbed, b.energy.absorbed);
  EXPECT_EQ(a.energy.escaped, b.energy.escaped);
  EXPECT_EQ(a.energy.lost_at_backs, b.energy.lost_at_backs);
  EXPECT_EQ(a.back_loss, b.back_loss);
  EXPECT_EQ(a.unreached_sides, b.unreached_sides);
  ASSERT_EQ(a.rounds.size(), b.rounds.size());
  for (std::size_t k = 0; k < a.rounds.size(); ++k) {
    EXPECT_EQ(a.rounds[k].rays, b.rounds[k].rays);
    EXPECT_EQ(a.rounds[k].error, b.rounds[k].error);
    EXPECT_EQ(a.rounds[k].sweeps, b.rounds[k].sweeps);
    EXPECT_EQ(a.rounds[k].residual, b.rounds[k].residual);
  }
}

TEST(SampledRepeat, one_two_and_five_threads_give_identical_bytes) {
  const auto patches = room();
  for (const bool smoothing : {true, false}) {
    const auto one = solve(patches, {.error = 0.02, .smoothing = smoothing}, 1);
    EXPECT_FALSE(one.solution.standard_error.front.empty());
    for (const int threads : {2, 5}) {
      const auto many = solve(patches, {.error = 0.02, .smoothing = smoothing}, threads);
      EXPECT_EQ(difference_of_light(one.solution, many.solution), "") << threads << " threads";
      expect_same_report(one.report, many.report);
    }
  }
}

TEST(SampledRepeat, random_numbers_without_any_of_the_switches_are_the_same_for_any_threads_too) {
  const auto patches = room();
  const SampledOptions plain = {.error = 0.05,
                                .low_discrepancy = false,
                                .stratified = false,
                                .importance = false,
                                .control_variate = false,
                                .multiple_importance = true,
                                .smoothing = false};
  EXPECT_EQ(difference_of_light(solve(patches, plain, 1).solution, solve(patches, plain, 5).solution), "");
}

TEST(SampledRepeat, stored_and_streamed_give_identical_bytes) {
  const auto patches = room();
  for (const bool smoothing : {true, false}) {
    const auto stored =
        solve(patches, {.error = 0.03, .memory = std::uint64_t{1} << 33, .smoothing = smoothing});
    const auto streamed = solve(patches, {.error = 0.03, .memory = 1, .smoothing = smoothing});
    EXPECT_FALSE(stored.report.streamed);
    EXPECT_TRUE(streamed.report.streamed);
    EXPECT_EQ(difference_of_light(stored.solution, streamed.solution), "");
    expect_same_report(stored.report, streamed.report);
  }
}

// A monitor that stops the work at the picture of a doubling. The first picture, by shooting, comes earlier.
Solved stopped_after(const PatchSet& patches, std::size_t doublings, Solution& last_picture) {
  std::size_t pictures = 0;
  return solve(
      patches, {.error = 0.0, .rays = std::uint64_t{1} << 24}, 2,
      [&](const Progress&) { return pictures == doublings + 1 ? Next::stop : Next::go_on; },
      [&](const Solution& light, const Progress&) {
        last_picture = light;
        ++pictures;
      });
}

TEST(SampledRepeat, a_run_stopped_at_a_doubling_is_a_run_bounded_to_it) {
  const auto patches = room();
  for (const std::size_t doublings : {1, 2, 4}) {
    Solution picture;
    const auto stopped = stopped_after(patches, doublings, picture);
    ASSERT_EQ(stopped.report.stop, StopReason::stopped_by_user);
    ASSERT_EQ(stopped.report.rounds.size(), doublings);
    EXPECT_EQ(stopped.report.rounds.back().rays, stopped.report.rays);
    EXPECT_EQ(difference_of_light(picture, stopped.solution), "") << "the picture shown last";

    const auto bounded = solve(patches, {.error = 0.0, .rays = stopped.report.rays});
    EXPECT_EQ(bounded.report.stop, StopReason::ray_limit);
    EXPECT_EQ(difference_of_light(bounded.solution, stopped.solution), "") << doublings << " doublings";
    expect_same_report(bounded.report, stopped.report);

    const auto longer = solve(patches, {.error = 0.0, .rays = stopped.report.rays * 5 / 2});
    ASSERT_GT(longer.report.rounds.size(), doublings);
    EXPECT_EQ(longer.report.rounds[doublings - 1].error, stopped.report.rounds.back().error)
        << "a longer run passes through the shorter one's answer";
  }
}

TEST(SampledRepeat, a_run_never_traces_more_than_it_may_once_it_has_begun_to_double) {
  const auto patches = room();
  const auto first = solve(patches, {.error = 0.05}).report.rounds.front().rays;
  for (const auto limit : {3 * first + 1, 10 * first - 1}) {
    const auto bounded = solve(patches, {.error = 0.0, .rays = limit});
    EXPECT_EQ(bounded.report.stop, StopReason::ray_limit);
    EXPECT_LE(bounded.report.rays, limit);
    EXPECT_GT(bounded.report.rays, limit / 4) << "it could have gone on";
  }
}

// Where half of the error is cheap it is the target; where it is not, nothing changes.
TEST(SampledRepeat, a_cheap_run_is_one_to_half_of_the_error) {
  const auto patches = room();
  const auto solved = [&](double error, std::uint64_t cheap_rays) {
    return solve(patches, {.error = error, .error_measure = ErrorMeasure::power, .cheap_rays = cheap_rays});
  };
  const auto cheap = solved(0.02, 100'000'000);
  EXPECT_LE(cheap.report.predicted_error, 0.01);
  EXPECT_EQ(difference_of_light(cheap.solution, solved(0.01, 0).solution), "");
  const auto plain = solved(0.02, 0);
  EXPECT_GT(plain.report.predicted_error, 0.01);
  EXPECT_EQ(difference_of_light(plain.solution, solved(0.02, 1000).solution), "");
}

// The target follows from the samples alone, so a run that is resumed ends where it would have ended.
TEST(SampledRepeat, a_cheap_run_ends_alike_after_a_stop) {
  const auto patches = room();
  const Context context(2);
  const Tracer tracer(patches, context);
  const SampledOptions options{
      .error = 0.02, .error_measure = ErrorMeasure::power, .cheap_rays = 100'000'000};
  std::vector<std::shared_ptr<const SampleState>> states;
  Solution whole, resumed;
  solve_sampled(patches, tracer, whole, options,
                {.keep = [&](auto state) { states.push_back(std::move(state)); }, .on_light = {}}, context);
  ASSERT_GT(states.size(), 1u);
  solve_sampled(patches, tracer, resumed, options, {.from = states[0], .on_light = {}}, context);
  EXPECT_EQ(difference_of_light(whole, resumed), "");
}

TEST(SampledRepeat, another_seed_gives_another_answer) {
  const auto patches = room();
  EXPECT_NE(solve(patches, {.error = 0.05, .seed = 1}).solution.irradiance.front,
            solve(patches, {.error = 0.05, .seed = 2}).solution.irradiance.front);
}

}  // namespace
}  // namespace luxel
