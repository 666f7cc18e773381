// SPDX-License-Identifier: Apache-2.0
// The errors that probes state, against their true errors over seeds; the same bytes on any number of
// threads.
#include <cmath>

#include <gtest/gtest.h>

#include "luxel/core/address.h"
#include "luxel/render/probe_light.h"
#include "luxel/render/probe_sphere.h"
#include "luxel/solve/relight.h"
#include "luxel/solve/sampled.h"

#include "support/known_rooms.h"
#include "support/probe_rig.h"

namespace luxel {
namespace {

using test::ProbeRig;

const std::vector<ProbePoint> points_in_cube = {
    {{0.5f, 0.5f, 0.2f}, {0, 0, 1}},  {{0.1f, 0.2f, 0.0f}, {0, 0, 1}},   {{0.9f, 0.4f, 0.4f}, {-1, 0, 0}},
    {{0.3f, 0.8f, 0.6f}, {0, 0, -1}}, {{0.35f, 0.35f, 0.0f}, {0, 0, 1}}, {{0.5f, 0.1f, 0.7f}, {0, 1, 0}},
};

Solution solution_of(const truth::KnownRoom& room) {
  auto s = test::even_light(room.patches, 0.0f);
  for (const bool back : {false, true})
    for (std::size_t i = 0; i < s.irradiance.front.size(); ++i)
      s.irradiance.of(back)[i] = static_cast<float>(room.truth.irradiance.of(back)[i]);
  return s;
}

// A lamp with a plate below it: soft shadows, and indirect light. 6 points and 100 seeds. Were the stated
// intervals right, the number of hits among 600 would be binomial; a coverage below 91.5 % has a chance of
// 1e-4 then, and none is required to be better than 99 %, at 1e-4 too.
TEST(ProbeErrors, contain_the_truth_95_times_in_100) {
  const auto room = truth::hung_plate();
  const ProbeRig rig(room.patches, solution_of(room));
  constexpr std::uint64_t seeds = 100;
  int hits = 0, all = 0;
  double squared = 0.0, stated = 0.0;
  for (const auto& point : points_in_cube) {
    const auto truth = rig.probe.at(point, {.error = 0.0003, .max_rays = 1u << 22}, 12345);
    ASSERT_TRUE(truth.reached);
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
      const auto light = rig.probe.at(point, {.error = 0.05}, mix64(seed));
      EXPECT_TRUE(light.reached);
      const auto error = light.illuminance - truth.illuminance;
      hits += std::abs(error) <= 1.96 * std::hypot(light.sampling_error, truth.sampling_error) ? 1 : 0;
      squared += error * error / (truth.illuminance * truth.illuminance);
      stated += light.sampling_error * light.sampling_error / (truth.illuminance * truth.illuminance);
      ++all;
    }
  }
  const auto coverage = static_cast<double>(hits) / all;
  EXPECT_GE(coverage, 0.915);
  EXPECT_LE(coverage, 0.99);
  // Stated errors are widened by 1.21.
  EXPECT_NEAR(std::sqrt(stated / squared), 1.21, 0.2);
}

// Solutions of 24 seeds, each with its own error, at the same points. All errors together: those of the
// probe's rays, and of the solution by its patches (an upper bound) or by its replicates. The points of one
// seed depend on each other, so the risk is judged by seeds: at least 20 of 24 must have all but one of their
// 6 points within 1.96; a seed misses two with a chance below 4 %, so that more than 4 of 24 do has one of
// 2e-3.
TEST(ProbeErrors, include_those_of_the_solution) {
  const auto room = truth::hung_plate();
  const ProbeRig rig(room.patches, solution_of(room));
  std::vector<ProbedLight> truth;
  for (const auto& point : points_in_cube)
    truth.push_back(rig.probe.at(point, {.error = 0.0005, .max_rays = 1u << 22}, 77));
  constexpr std::uint64_t seeds = 24;
  int good_by_patches = 0, good_by_replicates = 0;
  double bound = 0.0, spread = 0.0, squared = 0.0;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const SampledOptions options{.error = 0.1, .error_measure = ErrorMeasure::power, .seed = seed};
    Solution light;
    std::shared_ptr<const SampleState> state;
    solve_sampled(room.patches, rig.tracer, light, options, {nullptr, [&](auto s) { state = std::move(s); }},
                  rig.context);
    state = with_group_light(room.patches, rig.tracer, state, options, rig.context);
    const SolutionProbe by_patches(room.patches, light, rig.tracer);
    const SolutionProbe by_replicates(room.patches, light, rig.tracer, state.get());
    EXPECT_EQ(by_patches.solved().errors(), SolutionErrors::patches);
    EXPECT_EQ(by_replicates.solved().errors(), SolutionErrors::replicates);
    int hits_by_patches = 0, hits_by_replicates = 0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
      const ProbeOptions precise{.error = 0.004};
      const auto a = by_patches.at(points_in_cube[i], precise, seed),
                 b = by_replicates.at(points_in_cube[i], precise, seed);
      EXPECT_EQ(a.illuminance, b.illuminance) << "errors do not change the light";
      const auto error = std::abs(a.illuminance - truth[i].illuminance);
      hits_by_patches += error <= 1.96 * a.standard_error() ? 1 : 0;
      hits_by_replicates += error <= 1.96 * b.standard_error() ? 1 : 0;
      bound += a.standard_error() * a.standard_error();
      spread += b.standard_error() * b.standard_error();
      squared += error * error;
    }
    good_by_patches += hits_by_patches >= 5 ? 1 : 0;
    good_by_replicates += hits_by_replicates >= 5 ? 1 : 0;
  }
  EXPECT_GE(good_by_patches, 20);
  EXPECT_GE(good_by_replicates, 20);
  EXPECT_GT(bound, spread) << "the patches' errors are an upper bound";
  EXPECT_LT(std::sqrt(spread / squared), 2.0) << "the replicates' spread is no mere bound";
}

TEST(ProbeRepeats, on_any_number_of_threads) {
  const auto room = truth::hung_plate();
  const ProbeRig rig(room.patches, solution_of(room));
  const auto one = probe_light(rig.probe, points_in_cube, {}, Context(1));
  const auto five = probe_light(rig.probe, points_in_cube, {}, Context(5));
  const auto sphere = probe_spheres(rig.probe, points_in_cube, 9, {}, Context(1));
  const auto spheres = probe_spheres(rig.probe, points_in_cube, 9, {}, Context(5));
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].irradiance, five[i].irradiance);
    EXPECT_EQ(one[i].sampling_error, five[i].sampling_error);
    EXPECT_EQ(one[i].rays, five[i].rays);
    EXPECT_EQ(sphere[i].coefficients, spheres[i].coefficients);
  }
  const auto other = probe_light(rig.probe, points_in_cube, {.seed = 2}, Context(2));
  EXPECT_NE(one[0].illuminance, other[0].illuminance);
}

}  // namespace
}  // namespace luxel
