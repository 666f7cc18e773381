// SPDX-License-Identifier: Apache-2.0
// What stays while a live scene changes its method, its lamps and colours; its clock; what is answered beside
// the solver.
#include <algorithm>
#include <chrono>
#include <thread>

#include <gtest/gtest.h>

#include "luxel/session/diagnose.h"
#include "luxel/session/live_answers.h"
#include "luxel/session/live_scene.h"
#include "luxel/session/relit_patches.h"
#include "luxel/session/sideline.h"
#include "luxel/solution/solution_file.h"
#include "luxel/solve/relight.h"

#include "support/live_cornell.h"

namespace luxel {
namespace {

TEST(LiveScene, changes_its_method) {
  LiveScene live(cornell, endless());
  ASSERT_TRUE(wait_until([&] { return !live.status().history.empty(); }));
  auto light = endless().light;
  light.method = LightOptions::by_lines;
  live.solve(light);
  ASSERT_TRUE(wait_for_idle(live));
  EXPECT_EQ(live.light()->solution.provenance.method, "lines");
  EXPECT_FALSE(live.status().can_relight);
  light.method = "by magic";
  live.solve(light);
  ASSERT_TRUE(wait_for_idle(live));
  EXPECT_NE(live.status().error_message.find("by magic"), std::string::npos);
  EXPECT_EQ(live.light()->solution.provenance.method, "lines");
}

double mean(const std::vector<float>& values) {
  double sum = 0.0;
  for (const auto value : values) sum += static_cast<double>(value);
  return sum / static_cast<double>(values.size());
}

Lighting all_lamps(const LiveScene& live, float factor) {
  Lighting lighting;
  lighting.lamps.assign(live.mesh()->patches->group_count() * live.mesh()->patches->band_count(), factor);
  return lighting;
}

// By rays of its own, so that the same random numbers give light in exact proportion to the lamps.
LightOptions shooting() {
  auto light = coarse().light;
  light.method = LightOptions::by_shooting;
  light.shooting.rays = 20'000;
  return light;
}

TEST(LiveMethods, another_method_solves_with_the_lamps_that_were_set) {
  LiveScene live(cornell, coarse());
  live.solve(shooting());
  ASSERT_TRUE(wait_for_idle(live));
  const auto own = live.light();
  EXPECT_FALSE(own->is_relit);
  live.solve(coarse().light);
  ASSERT_TRUE(wait_for_idle(live));
  const auto sampled = live.light();
  live.relight(all_lamps(live, 0.5f));
  ASSERT_TRUE(wait_for_idle(live));
  live.solve(shooting());
  ASSERT_TRUE(wait_for_idle(live));
  EXPECT_EQ(live.status().error_message, "");
  const auto half = live.light();
  EXPECT_TRUE(half->is_relit);
  EXPECT_EQ(half->solution.provenance.method, own->solution.provenance.method);
  EXPECT_NE(half->solution.provenance.command_line.find("--tint"), std::string::npos);
  for (std::size_t i = 0; i < front(own).size(); ++i)
    EXPECT_NEAR(front(half)[i], 0.5f * front(own)[i], 1e-4f * front(own)[i]);
  // And back: the samples' light of the same lamps.
  live.solve(coarse().light);
  ASSERT_TRUE(wait_for_idle(live));
  EXPECT_TRUE(live.light()->is_relit);
  for (std::size_t i = 0; i < front(sampled).size(); ++i)
    EXPECT_NEAR(front(live.light())[i], 0.5f * front(sampled)[i], 1e-4f * front(sampled)[i]);
  live.relight({});
  ASSERT_TRUE(wait_for_idle(live));
  EXPECT_EQ(front(live.light()), front(sampled));
}

TEST(LiveMethods, lamps_and_colours_change_by_a_new_solve_where_there_are_no_samples) {
  LiveScene live(cornell, coarse());
  live.solve(shooting());
  ASSERT_TRUE(wait_for_idle(live));
  const auto own = live.light();
  auto lighting = all_lamps(live, 3.0f);
  live.relight(lighting);
  ASSERT_TRUE(wait_for_idle(live));
  EXPECT_NEAR(mean(front(live.light())), 3.0 * mean(front(own)), 1e-4 * mean(front(own)));
  const auto& patches = *live.mesh()->patches;
  lighting.reflectance.assign(patches.materials.size() * patches.band_count(), 0.0f);
  live.relight(lighting);
  ASSERT_TRUE(wait_for_idle(live));
  EXPECT_LT(mean(front(live.light())), 2.5 * mean(front(own))) << "nothing comes back from black walls";
  const auto file = fresh("black.vtkhdf");
  live.save_solution(file);
  live.relight({});
  ASSERT_TRUE(wait_for_idle(live));
  EXPECT_EQ(front(live.light()), front(own));
  EXPECT_EQ(read_solution(file).patches.materials[0].reflectance[0], 0.0f);
}

TEST(LiveMethods, a_solve_that_is_under_way_begins_again_with_other_lamps) {
  auto settings = coarse();
  settings.light = shooting();
  LiveScene live(cornell, settings);
  live.set_stepping(true);
  ASSERT_TRUE(wait_until([&] { return live.status().is_paused; }));
  live.relight(all_lamps(live, 2.0f));
  live.set_stepping(false);
  live.resume();
  ASSERT_TRUE(wait_until([&] { return live.status().is_idle && live.light()->is_relit; }));
  EXPECT_TRUE(live.light()->is_last);
  EXPECT_EQ(live.status().stop, StopReason::converged);
}

TEST(LiveMethods, relit_patches_are_those_that_samples_are_relit_with) {
  LiveScene live(cornell, coarse());
  ASSERT_TRUE(wait_for_idle(live));
  auto lighting = all_lamps(live, 0.25f);
  const auto& own = *live.mesh()->patches;
  for (std::size_t i = 0; i < own.materials.size() * own.band_count(); ++i)
    lighting.reflectance.push_back(0.01f * static_cast<float>(i));
  live.relight(lighting);
  ASSERT_TRUE(wait_for_idle(live));
  const auto& by_samples = *live.light()->mesh.patches;
  const auto patches = relit_patches(own, lighting);
  EXPECT_EQ(patches.scene_fingerprint, by_samples.scene_fingerprint);
  for (std::size_t m = 0; m < patches.materials.size(); ++m) {
    EXPECT_EQ(patches.materials[m].emittance, by_samples.materials[m].emittance);
    EXPECT_EQ(patches.materials[m].reflectance, by_samples.materials[m].reflectance);
  }
}

TEST(LiveMethods, the_time_that_is_allowed_does_not_pass_during_a_pause) {
  auto settings = endless();
  settings.light.sampled.seconds = 1.0;
  LiveScene live(cornell, settings);
  ASSERT_TRUE(wait_until([&] { return !live.status().history.empty(); }));
  live.pause();
  std::this_thread::sleep_for(std::chrono::milliseconds(1500));
  EXPECT_FALSE(live.status().is_idle);
  live.resume();
  ASSERT_TRUE(wait_for_idle(live));
  EXPECT_EQ(live.status().stop, StopReason::time_limit);
  EXPECT_EQ(live.light()->solution.stop, StopReason::time_limit);
  EXPECT_GE(live.status().seconds, 1.0);
  EXPECT_GT(live.light()->solution.predicted_error, 0.0);
}

TEST(LiveMethods, a_solution_without_the_light_of_each_lamp_says_so) {
  LiveScene live(cornell, endless());
  ASSERT_TRUE(wait_until([&] { return live.status().history.size() > 1; }));
  live.pause();
  const auto early = fresh("early.vtkhdf");
  live.save_solution(early);
  const auto said = [&] {
    const auto messages = live.status().messages;
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

// No solver is there at all: it waits for none, and none for it.
TEST(Sideline, answers_without_the_solver) {
  Board board;
  const auto file = fresh("sideline.vtkhdf");
  {
    LiveScene live(cornell, coarse());
    ASSERT_TRUE(wait_for_idle(live));
    live.save_solution(file);
    ASSERT_TRUE(wait_for_idle(live));
    board.mesh = live.mesh();
    board.light = live.light();
  }
  board.is_open = board.diagnostics_requested = true;
  board.second = file;
  std::thread beside([&] { Sideline(board, cornell, 1).go(); });
  EXPECT_TRUE(wait_until([&] {
    const std::lock_guard lock(board.mutex);
    return !board.awaits_answers();
  }));
  {
    const std::lock_guard lock(board.mutex);
    board.closes = true;
  }
  board.changed.notify_all();
  beside.join();
  EXPECT_EQ(board.status.error_message, "");
  ASSERT_TRUE(board.diagnostics && board.difference);
  EXPECT_EQ(board.diagnostics->count(Severity::error), 0u);
  EXPECT_EQ(board.difference->comparison.relative_rms, 0.0);
}

}  // namespace
}  // namespace luxel
