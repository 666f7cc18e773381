// SPDX-License-Identifier: Apache-2.0
// State that persists while a session changes its method, lamps and colours; its clock; and queries while the
// solver continues.
#include <algorithm>
#include <chrono>
#include <thread>

#include <gtest/gtest.h>

#include "luxel/session/background_queries.h"
#include "luxel/session/diagnose.h"
#include "luxel/session/progressive_session.h"
#include "luxel/session/relit_patches.h"
#include "luxel/solution/sample_state.h"
#include "luxel/solution/solution_file.h"
#include "luxel/solve/relight.h"

#include "support/cornell_session.h"

namespace luxel {
namespace {

TEST(ProgressiveSession, changes_its_method) {
  ProgressiveSession live(cornell, endless());
  ASSERT_TRUE(wait_until([&] { return !live.snapshot().status.history.empty(); }));
  auto light = endless().light;
  light.method = Method::lines;
  live.solve(light);
  ASSERT_TRUE(wait_for_idle(live));
  EXPECT_EQ(live.snapshot().light->solution.provenance.method, "lines");
  EXPECT_FALSE(live.snapshot().status.can_relight);
}

TEST(Methods, have_names_and_no_others) {
  for (const auto method : all_methods()) {
    EXPECT_EQ(method_named(name(method)), method);
    EXPECT_FALSE(description(method).empty());
  }
  EXPECT_EQ(method_named("by magic"), std::nullopt);
}

double mean(const std::vector<float>& values) {
  double sum = 0.0;
  for (const auto value : values) sum += static_cast<double>(value);
  return sum / static_cast<double>(values.size());
}

Lighting all_lamps(const ProgressiveSession& live, float factor) {
  Lighting lighting;
  lighting.lamps.assign(
      live.snapshot().mesh->patches->group_count() * live.snapshot().mesh->patches->band_count(), factor);
  return lighting;
}

// By rays of its own, so that the same random numbers give light in exact proportion to the lamps.
LightOptions shooting() {
  auto light = coarse().light;
  light.method = Method::shooting;
  light.shooting.rays = 20'000;
  return light;
}

TEST(SessionMethods, another_method_solves_with_the_lamps_that_were_set) {
  ProgressiveSession live(cornell, coarse());
  live.solve(shooting());
  ASSERT_TRUE(wait_for_idle(live));
  const auto own = live.snapshot().light;
  EXPECT_FALSE(own->is_relit);
  live.solve(coarse().light);
  ASSERT_TRUE(wait_for_idle(live));
  const auto sampled = live.snapshot().light;
  live.relight(all_lamps(live, 0.5f));
  ASSERT_TRUE(wait_for_idle(live));
  live.solve(shooting());
  ASSERT_TRUE(wait_for_idle(live));
  EXPECT_EQ(live.snapshot().status.error_message, "");
  const auto half = live.snapshot().light;
  EXPECT_TRUE(half->is_relit);
  EXPECT_EQ(half->solution.provenance.method, own->solution.provenance.method);
  EXPECT_NE(half->solution.provenance.command_line.find("--tint"), std::string::npos);
  for (std::size_t i = 0; i < front(own).size(); ++i)
    EXPECT_NEAR(front(half)[i], 0.5f * front(own)[i], 1e-4f * front(own)[i]);
  // And back: the samples' light of the same lamps.
  live.solve(coarse().light);
  ASSERT_TRUE(wait_for_idle(live));
  EXPECT_TRUE(live.snapshot().light->is_relit);
  // The iteration ends by the change of the whole scene's light: where it is dark, above the lamp, that is
  // more than 1e-4 of the light there.
  const auto change = 1e-4f * static_cast<float>(mean(front(sampled)));
  for (std::size_t i = 0; i < front(sampled).size(); ++i)
    EXPECT_NEAR(front(live.snapshot().light)[i], 0.5f * front(sampled)[i], change);
  live.relight({});
  ASSERT_TRUE(wait_for_idle(live));
  EXPECT_EQ(front(live.snapshot().light), front(sampled));
}

TEST(SessionMethods, lamps_and_colours_change_by_a_new_solve_where_there_are_no_samples) {
  ProgressiveSession live(cornell, coarse());
  live.solve(shooting());
  ASSERT_TRUE(wait_for_idle(live));
  const auto own = live.snapshot().light;
  auto lighting = all_lamps(live, 3.0f);
  live.relight(lighting);
  ASSERT_TRUE(wait_for_idle(live));
  EXPECT_NEAR(mean(front(live.snapshot().light)), 3.0 * mean(front(own)), 1e-4 * mean(front(own)));
  const auto& patches = *live.snapshot().mesh->patches;
  lighting.reflectance.assign(patches.materials.size() * patches.band_count(), 0.0f);
  live.relight(lighting);
  ASSERT_TRUE(wait_for_idle(live));
  EXPECT_LT(mean(front(live.snapshot().light)), 2.5 * mean(front(own)))
      << "nothing comes back from black walls";
  const auto file = fresh("black.vtkhdf");
  live.save_solution(file);
  live.relight({});
  ASSERT_TRUE(wait_for_idle(live));
  EXPECT_EQ(front(live.snapshot().light), front(own));
  EXPECT_EQ(read_solution(file).patches.materials[0].reflectance[0], 0.0f);
}

TEST(SessionMethods, a_solve_that_is_under_way_begins_again_with_other_lamps) {
  auto settings = coarse();
  settings.light = shooting();
  ProgressiveSession live(cornell, settings);
  live.set_stepping(true);
  ASSERT_TRUE(wait_until([&] { return live.snapshot().status.is_paused; }));
  live.relight(all_lamps(live, 2.0f));
  live.set_stepping(false);
  live.resume();
  ASSERT_TRUE(wait_until([&] { return live.snapshot().status.is_idle && live.snapshot().light->is_relit; }));
  EXPECT_TRUE(live.snapshot().light->is_last);
  EXPECT_EQ(live.snapshot().status.stop, StopReason::converged);
}

TEST(SessionMethods, relit_patches_are_those_that_samples_are_relit_with) {
  ProgressiveSession live(cornell, coarse());
  ASSERT_TRUE(wait_for_idle(live));
  auto lighting = all_lamps(live, 0.25f);
  const auto& own = *live.snapshot().mesh->patches;
  for (std::size_t i = 0; i < own.materials.size() * own.band_count(); ++i)
    lighting.reflectance.push_back(0.01f * static_cast<float>(i));
  live.relight(lighting);
  ASSERT_TRUE(wait_for_idle(live));
  const auto& by_samples = *live.snapshot().light->mesh.patches;
  const auto patches = relit_patches(own, lighting);
  EXPECT_EQ(patches.scene_fingerprint, by_samples.scene_fingerprint);
  for (std::size_t m = 0; m < patches.materials.size(); ++m) {
    EXPECT_EQ(patches.materials[m].emittance, by_samples.materials[m].emittance);
    EXPECT_EQ(patches.materials[m].reflectance, by_samples.materials[m].reflectance);
  }
}

TEST(SessionMethods, the_time_that_is_allowed_does_not_pass_during_a_pause) {
  auto settings = endless();
  settings.light.sampled.seconds = 1.0;
  settings.begins_at_once = false;
  ProgressiveSession live(cornell, settings);
  ASSERT_TRUE(wait_for_idle(live));
  live.pause();
  live.solve(settings.light);
  ASSERT_TRUE(wait_until([&] { return live.snapshot().status.stage == "light"; }));
  std::this_thread::sleep_for(std::chrono::milliseconds(1500));
  EXPECT_FALSE(live.snapshot().status.is_idle);
  live.resume();
  ASSERT_TRUE(wait_for_idle(live));
  const auto now = live.snapshot();
  EXPECT_EQ(now.status.stop, StopReason::time_limit);
  EXPECT_EQ(now.light->solution.stop, StopReason::time_limit);
  EXPECT_GE(now.status.seconds, 1.0);
  EXPECT_GT(now.light->solution.predicted_error, 0.0);
}

TEST(SessionMethods, a_solution_without_the_light_of_each_lamp_says_so) {
  ProgressiveSession live(cornell, endless());
  ASSERT_TRUE(wait_until([&] { return live.snapshot().status.history.size() > 1; }));
  live.pause();
  const auto early = fresh("early.vtkhdf");
  live.save_solution(early);
  const auto said = [&] {
    const auto messages = live.snapshot().status.messages;
    return messages.empty() ? std::string() : messages.back().text;
  };
  ASSERT_TRUE(wait_until([&] { return said().find("early.vtkhdf is written") != std::string::npos; }));
  EXPECT_NE(said().find("which is not known yet"), std::string::npos) << said();
  EXPECT_TRUE(read_stored_run(early).samples->gathered.empty());
  live.stop();
  ASSERT_TRUE(wait_for_idle(live));
  const auto late = fresh("late.vtkhdf");
  live.save_solution(late);
  ASSERT_TRUE(wait_for_idle(live));
  EXPECT_TRUE(said().ends_with("is written")) << said();
  EXPECT_FALSE(read_stored_run(late).samples->gathered.empty());
}

// Without a solver's thread: neither waits for the other.
TEST(BackgroundQueries, are_answered_without_the_solver) {
  SessionChannels channels;
  const auto file = fresh("background.vtkhdf");
  {
    ProgressiveSession live(cornell, coarse());
    ASSERT_TRUE(wait_for_idle(live));
    live.save_solution(file);
    ASSERT_TRUE(wait_for_idle(live));
    SolverState state;
    state.mesh = live.snapshot().mesh;
    state.light = live.snapshot().light;
    state.is_open = true;
    channels.solver.publish(state);
  }
  channels.to_background.push(FindDiagnostics{});
  const auto last = channels.to_background.push(CompareWith{file});
  std::thread background([&] { BackgroundQueries(channels, cornell, 1).run(); });
  EXPECT_TRUE(wait_until([&] {
    const auto answers = channels.answers.get();
    return answers->commands_done == last && !answers->is_busy;
  }));
  channels.to_background.close();
  background.join();
  EXPECT_EQ(channels.failures.last().message, "");
  const auto answers = channels.answers.get();
  ASSERT_TRUE(answers->diagnostics && answers->difference);
  EXPECT_EQ(answers->diagnostics->count(Severity::error), 0u);
  EXPECT_EQ(answers->difference->comparison.relative_rms, 0.0);
}

}  // namespace
}  // namespace luxel
