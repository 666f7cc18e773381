// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "luxel/classical/shooting.h"
#include "luxel/classical/stochastic_jacobi.h"
#include "luxel/core/error.h"
#include "luxel/core/hint.h"
#include "luxel/lamps/side_power.h"
#include "luxel/lamps/sky_box.h"
#include "luxel/patch/make_patches.h"

#include "support/truth_scenes.h"

namespace luxel {
namespace {

// Two opposed plates, open all round; the upper is one-sided and turned away, so that all three fates of a
// ray occur.
PatchSet leaky_scene() {
  truth::SceneBuilder b;
  b.material("lamp", Vec3(0.5f), {1.0f, 0.1f, 3.0f}).quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
  b.material("turned_away", 0.5f, 0.0f, false).quad({0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1});
  b.material("beside", 0.7f, 0.0f).quad({1, 0, 0}, {1, 0, 2}, {1, 1, 2}, {1, 1, 0});
  return make_patches(b.scene(), {.max_edge = 0.3f});
}

void expect_balanced(const Arrival& a) {
  for (std::size_t b = 0; b < 3; ++b) {
    std::int64_t total = a.escaped[b];
    for (std::size_t i = b; i < a.arrived.size(); i += 3) total += a.arrived[i];
    for (std::size_t i = b; i < a.absorbed.size(); i += 3) total += a.absorbed[i];
    EXPECT_EQ(total, a.shot[b]) << "band " << b;
    EXPECT_GT(a.escaped[b], 0);
  }
}

TEST(Energy, is_conserved_to_the_last_unit_of_fixed_point) {
  const auto patches = leaky_scene();
  const Context context;
  const Tracer tracer(patches, context);
  const auto arrival = shoot(patches, tracer, lamp_power(patches), {.rays = 300'001}, context);
  EXPECT_EQ(arrival.rays, 300'001u);
  expect_balanced(arrival);
  EXPECT_GT(std::accumulate(arrival.absorbed.begin(), arrival.absorbed.end(), std::int64_t{0}), 0);
}

// Light of the sky that misses the scene, or reaches the backs of one-sided materials, is not shot.
TEST(Energy, of_lamps_and_sky_is_conserved_to_the_last_unit_of_fixed_point) {
  auto patches = leaky_scene();
  patches.sky = {1.0f, 2.0f, 0.5f};
  const Context context;
  const Tracer tracer(patches, context);
  auto leaving = lamp_power(patches);
  const auto lamps = shoot(patches, tracer, leaving, {.rays = 300'001}, context);
  add_sky_power(patches, SkyBox(patches), leaving);
  const auto arrival = shoot(patches, tracer, leaving, {.rays = 300'001}, context);
  expect_balanced(arrival);
  for (std::size_t b = 0; b < 3; ++b) {
    EXPECT_GT(arrival.from_sky[b], 0);
    EXPECT_NEAR(arrival.scale.watts(arrival.shot[b] - arrival.from_sky[b]), lamps.scale.watts(lamps.shot[b]),
                1e-3 * lamps.scale.watts(lamps.shot[b]));
  }
}

TEST(Energy, shot_is_what_was_asked_to_be_shot) {
  const auto patches = leaky_scene();
  const Context context;
  const Tracer tracer(patches, context);
  const auto arrival = shoot(patches, tracer, lamp_power(patches), {.rays = 1'000'000}, context);
  const double asked[3] = {1.0, 0.1f, 3.0};  // W: one square metre
  for (std::size_t b = 0; b < 3; ++b)
    EXPECT_NEAR(arrival.scale.watts(arrival.shot[b]), asked[b], 3e-7 * asked[b]);  // patch areas are floats
}

TEST(Energy, is_conserved_by_a_shot_that_was_stopped_and_its_unshot_fraction_is_reported) {
  const auto patches = leaky_scene();
  const Context context;
  const Tracer tracer(patches, context);
  int calls = 0;
  const auto arrival =
      shoot(patches, tracer, lamp_power(patches), {.rays = 100'000, .batch = 10'000},
            context.with_monitor([&](const Progress&) { return ++calls == 3 ? Next::stop : Next::go_on; }));
  EXPECT_DOUBLE_EQ(arrival.fraction, 0.3);
  EXPECT_EQ(arrival.rays, 30'000u);
  expect_balanced(arrival);
  EXPECT_NEAR(arrival.scale.watts(arrival.shot[0]) / arrival.fraction, 1.0, 1e-3);
}

TEST(Energy, batches_are_parts_of_one_plan_and_change_nothing) {
  const auto patches = leaky_scene();
  const Context context;
  const Tracer tracer(patches, context);
  const auto whole = shoot(patches, tracer, lamp_power(patches), {.rays = 123'457}, context);
  const auto parts = shoot(patches, tracer, lamp_power(patches), {.rays = 123'457, .batch = 1000}, context);
  EXPECT_EQ(whole.arrived, parts.arrived);
  EXPECT_EQ(whole.escaped, parts.escaped);
}

TEST(Energy, emitted_equals_absorbed_escaped_lost_and_unshot) {
  const auto patches = leaky_scene();
  const Context context;
  const Tracer tracer(patches, context);
  Solution solution;
  const auto report =
      solve_stochastic_jacobi(patches, tracer, solution, {.rays = 200'000, .tolerance = 1e-3}, context);
  EXPECT_EQ(report.stop, StopReason::converged);
  for (std::size_t b = 0; b < 3; ++b) {
    const auto& e = report.energy;
    EXPECT_NEAR(e.absorbed[b] + e.escaped[b] + e.lost_at_backs[b] + e.unshot[b], e.emitted[b],
                1e-9 * e.emitted[b]);
    EXPECT_GT(e.lost_at_backs[b], 0.0);
  }
  EXPECT_LE(report.unshot_fraction, 1e-3);
  EXPECT_GT(report.back_loss[1], 0.0);
  EXPECT_EQ(report.back_loss[0] + report.back_loss[2], 0.0);
}

TEST(Energy, a_step_carries_the_same_quantum_as_the_first) {
  const auto patches = make_patches(truth::cube_a(), {.max_edge = 0.5f});
  const Context context;
  const Tracer tracer(patches, context);
  Solution solution;
  const auto report =
      solve_stochastic_jacobi(patches, tracer, solution, {.rays = 100'000, .tolerance = 0.01}, context);
  ASSERT_GT(report.steps.size(), 3u);
  EXPECT_EQ(report.steps[0].rays, 100'000u);
  for (std::size_t k = 1; k < report.steps.size(); ++k)
    EXPECT_EQ(static_cast<double>(report.steps[k].rays),
              std::round(1e5 * report.steps[k - 1].unshot_fraction));
}

TEST(Energy, a_stopped_run_is_an_unbiased_estimate_of_the_bounces_begun) {
  const auto patches = make_patches(truth::cube_a(), {.max_edge = 0.5f});
  const Context context;
  const Tracer tracer(patches, context);
  Solution solution;
  const auto report = solve_stochastic_jacobi(
      patches, tracer, solution, {.rays = 8'000'000},
      context.with_monitor([&](const Progress& p) { return p.rays > 3'000'000 ? Next::stop : Next::go_on; }));
  EXPECT_EQ(report.stop, StopReason::stopped_by_user);
  EXPECT_EQ(solution.stop, StopReason::stopped_by_user);
  EXPECT_EQ(report.steps.size(), 1u);
  // One bounce in a closed cube: half of what the ceiling emitted is reflected and waits.
  EXPECT_NEAR(report.unshot_fraction, 0.5, 0.002);
  double received = 0.0;
  for (std::size_t p = 0; p < patches.size(); ++p)
    received += static_cast<double>(patches.area[p]) * solution.irradiance.front[3 * p];
  EXPECT_NEAR(received, 1.0, 0.002);
  // Its error is that of the rays it shot, not of the requested number: each carried three watts (one per
  // band) over them.
  const auto quantum = 3.0 / static_cast<double>(report.rays);
  double variance = 0.0;
  double square = 0.0;
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const double H = 3.0 * static_cast<double>(solution.irradiance.front[3 * p]);
    variance += quantum * H;
    square += static_cast<double>(patches.area[p]) * H * H;
  }
  EXPECT_NEAR(report.predicted_error, std::sqrt(variance / square), 1e-3 * report.predicted_error);
}

TEST(Energy, a_scene_without_a_lamp_is_refused_with_advice) {
  auto scene = truth::cube_a();
  for (auto& m : scene.materials) m.emittance = Vec3(0.0f);
  const auto patches = make_patches(scene, {.max_edge = no_max_edge});
  const Context context;
  const Tracer tracer(patches, context);
  Solution solution;
  try {
    solve_stochastic_jacobi(patches, tracer, solution, {.rays = 1000}, context);
    FAIL() << "expected an InputError";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("Ke"), std::string::npos) << error.what();
    const auto hints = hints_of(error);
    ASSERT_EQ(hints.size(), 1u);
    EXPECT_EQ(hints[0].setting, Setting::sky);
  }
}

}  // namespace
}  // namespace luxel
