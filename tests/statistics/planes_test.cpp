// SPDX-License-Identifier: Apache-2.0
// The intervals of calculation planes contain the true figures 95 times in 100.
#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <utility>

#include <gtest/gtest.h>

#include "luxel/lighting/calculation_plane.h"
#include "luxel/solve/relight.h"
#include "luxel/solve/sampled.h"

#include "support/known_rooms.h"
#include "support/probe_rig.h"

namespace luxel {
namespace {

struct Misses {
  int mean = 0, min = 0, max = 0, min_over_mean = 0, min_over_max = 0;

  static bool is_missed(const Figure& figure, double truth) {
    const auto rounding = 1e-9 * truth;
    return figure.low > truth + rounding || figure.high < truth - rounding;
  }
};

// Noise as a measurement has it: eight replicates of sampling per point, and eight replicates of the
// solution, whose errors are partly common to all points. Truth: 30 points, six of them nearly as dark as the
// darkest.
GridSamples noisy(const std::vector<double>& truth, double sampling, double solution,
                  std::mt19937_64& random) {
  constexpr int replicates = 8;
  std::normal_distribution<double> normal;
  GridSamples samples;
  std::vector<std::vector<double>> light(replicates, std::vector<double>(truth.size()));
  for (auto& of_replicate : light) {
    const auto common = normal(random);
    for (std::size_t i = 0; i < truth.size(); ++i)
      of_replicate[i] =
          truth[i] * (1.0 + solution * std::sqrt(1.0 * replicates) * (0.8 * common + 0.6 * normal(random)));
  }
  for (std::size_t i = 0; i < truth.size(); ++i) {
    double of_solution = 0.0, mean = 0.0, squares = 0.0;
    for (const auto& of_replicate : light) of_solution += of_replicate[i] / replicates;
    std::vector<double> values;
    for (int r = 0; r < replicates; ++r) {
      values.push_back(of_solution + truth[i] * sampling * std::sqrt(1.0 * replicates) * normal(random));
      mean += values.back() / replicates;
    }
    for (const auto v : values) squares += (v - mean) * (v - mean);
    samples.value.push_back(mean);
    samples.sampling_error.push_back(std::sqrt(squares / (replicates * (replicates - 1))));
  }
  samples.replicates = light;
  return samples;
}

// 1000 measurements. Were an interval right at 95 %, the number of misses would be binomial with mean 50 and
// standard deviation 6.9; more than 85 have a chance below 1e-5. The mean's interval is exact and not too
// wide either: fewer than 18 misses have a chance below 1e-6.
TEST(PlaneIntervals, contain_the_truth) {
  std::vector<double> truth;
  for (int i = 0; i < 30; ++i) truth.push_back(i < 6 ? 300.0 + 2.0 * i : 400.0 + 5.0 * i);
  double mean = 0.0;
  for (const auto x : truth) mean += x / 30.0;
  const auto max = *std::max_element(truth.begin(), truth.end());
  std::mt19937_64 random(1);
  for (const auto& [sampling, solution] : {std::pair{0.02, 0.0}, {0.0, 0.02}, {0.02, 0.02}, {0.005, 0.02}}) {
    Misses misses;
    for (int trial = 0; trial < 1000; ++trial) {
      const auto samples = noisy(truth, sampling, solution, random);
      const GridFigures figures(samples);
      misses.mean += Misses::is_missed(figures.mean(), mean) ? 1 : 0;
      misses.min += Misses::is_missed(figures.min(), 300.0) ? 1 : 0;
      misses.max += Misses::is_missed(figures.max(), max) ? 1 : 0;
      misses.min_over_mean += Misses::is_missed(figures.min_over_mean(), 300.0 / mean) ? 1 : 0;
      misses.min_over_max += Misses::is_missed(figures.min_over_max(), 300.0 / max) ? 1 : 0;
    }
    EXPECT_LE(misses.mean, 85) << sampling << " " << solution;
    EXPECT_GE(misses.mean, 18) << sampling << " " << solution;
    EXPECT_LE(misses.min, 85) << sampling << " " << solution;
    EXPECT_LE(misses.max, 85) << sampling << " " << solution;
    EXPECT_LE(misses.min_over_mean, 85) << sampling << " " << solution;
    EXPECT_LE(misses.min_over_max, 85) << sampling << " " << solution;
  }
}

// Soft shadow below a plate, measured roughly with 100 seeds; truth from a measurement 100 times as accurate.
// At 95 %, more than 14 misses of 100 have a chance below 2e-4.
TEST(PlaneIntervals, of_measured_planes_contain_the_truth) {
  const auto room = truth::hung_plate();
  auto light = test::even_light(room.patches, 0.0f);
  for (const bool back : {false, true})
    for (std::size_t i = 0; i < light.irradiance.front.size(); ++i)
      light.irradiance.of(back)[i] = static_cast<float>(room.truth.irradiance.of(back)[i]);
  const test::ProbeRig rig(room.patches, light);
  CalculationArea area;
  area.name = "plane";
  area.polygon = {{0.1, 0.1, 0.2}, {0.9, 0.1, 0.2}, {0.9, 0.9, 0.2}, {0.1, 0.9, 0.2}};
  area.spacing = 0.2;
  const AreaScene scene{rig.patches, rig.light, rig.tracer, {0, 0, 1}, nullptr};
  const auto truth =
      measure_plane(rig.probe, area, scene, {.error = 0.0005, .max_rays = 1u << 21, .seed = 999}, rig.context)
          .value();
  Misses misses;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const auto r = measure_plane(rig.probe, area, scene, {.error = 0.05, .seed = seed}, rig.context).value();
    misses.mean += Misses::is_missed(r.mean, truth.mean.value) ? 1 : 0;
    misses.min += Misses::is_missed(r.min, truth.min.value) ? 1 : 0;
    misses.max += Misses::is_missed(r.max, truth.max.value) ? 1 : 0;
    misses.min_over_mean += Misses::is_missed(r.min_over_mean, truth.min_over_mean.value) ? 1 : 0;
  }
  EXPECT_LE(misses.mean, 14);
  EXPECT_LE(misses.min, 14);
  EXPECT_LE(misses.max, 14);
  EXPECT_LE(misses.min_over_mean, 14);
}

// Solutions of 24 seeds, each with its own error, which all points of a plane share; measured precisely, so
// that nearly all of the error is the solution's, by its replicates. At 95 %, more than 5 misses of 24 have a
// chance of 1.2e-3.
TEST(PlaneIntervals, contain_the_truth_in_spite_of_the_solutions_error) {
  const auto room = truth::hung_plate();
  auto exact = test::even_light(room.patches, 0.0f);
  for (const bool back : {false, true})
    for (std::size_t i = 0; i < exact.irradiance.front.size(); ++i)
      exact.irradiance.of(back)[i] = static_cast<float>(room.truth.irradiance.of(back)[i]);
  const test::ProbeRig rig(room.patches, exact);
  CalculationArea area;
  area.name = "plane";
  area.polygon = {{0.1, 0.1, 0.2}, {0.9, 0.1, 0.2}, {0.9, 0.9, 0.2}, {0.1, 0.9, 0.2}};
  area.spacing = 0.2;
  const ProbeOptions precise{.error = 0.004};
  const AreaScene true_scene{rig.patches, rig.light, rig.tracer, {0, 0, 1}, nullptr};
  const auto truth =
      measure_plane(rig.probe, area, true_scene, {.error = 0.0005, .max_rays = 1u << 21}, rig.context)
          .value();
  Misses misses;
  double width = 0.0, squared = 0.0;
  constexpr std::uint64_t seeds = 24;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const SampledOptions options{.error = 0.1, .error_measure = ErrorMeasure::power, .seed = seed};
    Solution light;
    std::shared_ptr<const SampleState> state;
    solve_sampled(room.patches, rig.tracer, light, options, {nullptr, [&](auto s) { state = std::move(s); }},
                  rig.context);
    state = with_group_light(room.patches, rig.tracer, state, options, rig.context);
    const SolutionProbe probe(room.patches, light, rig.tracer, state.get());
    const AreaScene scene{room.patches, light, rig.tracer, {0, 0, 1}, nullptr};
    const auto r = measure_plane(probe, area, scene, precise, rig.context).value();
    EXPECT_EQ(r.solution_errors, SolutionErrors::replicates);
    misses.mean += Misses::is_missed(r.mean, truth.mean.value) ? 1 : 0;
    misses.min += Misses::is_missed(r.min, truth.min.value) ? 1 : 0;
    misses.max += Misses::is_missed(r.max, truth.max.value) ? 1 : 0;
    misses.min_over_mean += Misses::is_missed(r.min_over_mean, truth.min_over_mean.value) ? 1 : 0;
    width += (r.mean.high - r.mean.low) / seeds;
    squared += (r.mean.value - truth.mean.value) * (r.mean.value - truth.mean.value) / seeds;
  }
  EXPECT_LE(misses.mean, 5);
  EXPECT_LE(misses.min, 5);
  EXPECT_LE(misses.max, 5);
  EXPECT_LE(misses.min_over_mean, 5);
  // 2 x 2.36 standard errors for eight replicates: no mere bound.
  EXPECT_LT(width, 2.0 * 2.0 * 2.36 * std::sqrt(squared));
}

}  // namespace
}  // namespace luxel
