// SPDX-License-Identifier: Apache-2.0
// A scene that is solved in its own thread, as a window would use it.
#include "luxel/session/progressive_session.h"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <thread>

#include <gtest/gtest.h>

#include "luxel/session/diagnose.h"
#include "luxel/solution/sample_state.h"
#include "luxel/solution/solution_file.h"
#include "luxel/solve/bake.h"
#include "luxel/solve/relight.h"

#include "support/cornell_session.h"

namespace luxel {
namespace {

// The iteration ends by the change of the whole scene's light: where it is dark, above the lamp, that is more
// than 1e-4 of the light there.
float change_left(const std::vector<float>& light) {
  double sum = 0.0;
  for (const auto value : light) sum += static_cast<double>(value);
  return static_cast<float>(1e-4 * sum / static_cast<double>(light.size()));
}

TEST(ProgressiveSession, ends_with_the_bytes_of_a_bake) {
  const auto settings = coarse();
  ProgressiveSession live(cornell, settings);
  ASSERT_TRUE(wait_for_idle(live));
  EXPECT_EQ(live.snapshot().status.error_message, "");
  EXPECT_EQ(live.snapshot().status.stop, StopReason::error_reached);
  const auto file = fresh("same.vtkhdf");
  live.save_solution(file);
  ASSERT_TRUE(wait_for_idle(live));

  const Context context(1);
  const auto scene = load_scene(cornell);
  auto patches = make_patches_for_light(scene, settings.patches);
  set_light_groups(scene, {}, patches);
  const Tracer tracer(patches, context);
  Solution solution;
  std::shared_ptr<const SampleState> samples;
  solve_sampled(patches, tracer, solution, settings.light.sampled,
                {.keep = [&](auto state) { samples = state; }}, context);
  const auto expected = fresh("expected.vtkhdf");
  samples = with_group_light(patches, tracer, samples, settings.light.sampled, context);
  write_solution(expected, patches, solution, samples.get());
  EXPECT_EQ(bytes(file), bytes(expected));
}

TEST(ProgressiveSession, says_in_a_sentence_what_is_wrong_with_a_file) {
  ProgressiveSession missing("no-such-room.obj", coarse());
  ASSERT_TRUE(wait_for_idle(missing));
  EXPECT_NE(missing.snapshot().status.error_message.find("no-such-room.obj"), std::string::npos);
  EXPECT_EQ(missing.snapshot().mesh, nullptr);

  const auto file = fresh("broken.vtkhdf");
  std::ofstream(file) << "no solution";
  ProgressiveSession broken(file, coarse());
  ASSERT_TRUE(wait_for_idle(broken));
  EXPECT_NE(broken.snapshot().status.error_message.find("broken.vtkhdf"), std::string::npos);
  broken.solve({});
  ASSERT_TRUE(wait_for_idle(broken));
  EXPECT_EQ(broken.snapshot().status.errors, 2u);
}

// Unshot light over the emission of lamps.
double unshot_fraction(const SessionLight& light) {
  const auto& patches = *light.mesh.patches;
  double unshot = 0.0;
  double emitted = 0.0;
  for (std::size_t p = 0; p < patches.size(); ++p)
    for (std::size_t b = 0; b < 3; ++b) {
      const double area = patches.area[p];
      unshot += area * (light.unshot.front[3 * p + b] + light.unshot.back[3 * p + b]);
      emitted += area * patches.material_of(p).emittance[b];
    }
  return unshot / emitted;
}

TEST(ProgressiveSession, may_be_held_at_any_time_and_gives_the_same_light) {
  auto settings = coarse();
  settings.light.sampled.error = 0.02;
  ProgressiveSession straight(cornell, settings);
  ProgressiveSession held(cornell, settings);
  for (int i = 0; i < 200 && !held.snapshot().status.is_idle; ++i) {
    held.pause();
    EXPECT_TRUE(held.snapshot().status.is_paused);
    std::this_thread::sleep_for(std::chrono::microseconds(300 * (i % 7)));
    held.resume();
    std::this_thread::sleep_for(std::chrono::microseconds(500 * (i % 5)));
  }
  ASSERT_TRUE(wait_for_idle(straight) && wait_for_idle(held));
  EXPECT_EQ(front(straight.snapshot().light), front(held.snapshot().light));
}

TEST(ProgressiveSession, closes_at_any_moment) {
  for (int i = 0; i < 24; ++i) {
    ProgressiveSession live(cornell, endless());
    std::this_thread::sleep_for(std::chrono::microseconds(200 * i * i));
    if (i % 4 == 1) live.pause();
    if (i % 4 == 2) live.set_stepping(true);
    const auto begin = std::chrono::steady_clock::now();
    live.close();
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(5)) << "close number " << i;
  }
}

TEST(ProgressiveSession, saves_what_there_is_when_it_is_closed) {
  const auto file = fresh("closed.vtkhdf");
  ProgressiveSession live(cornell, endless());
  ASSERT_TRUE(wait_until([&] { return live.snapshot().status.history.size() > 1; }));
  live.close(file);
  const auto kept = read_stored_run(file);
  EXPECT_EQ(kept.baked.solution.stop, StopReason::stopped_by_user);
  EXPECT_EQ(kept.baked.solution.irradiance.front, front(live.snapshot().light));
  EXPECT_TRUE(kept.samples);
}

TEST(ProgressiveSession, goes_on_to_a_finer_error_without_losing_samples) {
  ProgressiveSession live(cornell, coarse());
  ASSERT_TRUE(wait_for_idle(live));
  const auto before = live.snapshot().light;
  live.set_error(0.003);
  EXPECT_FALSE(live.snapshot().status.is_idle);
  ASSERT_TRUE(wait_for_idle(live));
  const auto after = live.snapshot().light;
  EXPECT_LE(after->solution.predicted_error, 0.003);
  EXPECT_EQ(live.snapshot().status.stop, StopReason::error_reached);
  ASSERT_GT(after->samples->rounds.size(), before->samples->rounds.size());
  for (std::size_t i = 0; i < before->samples->rounds.size(); ++i)
    EXPECT_EQ(after->samples->rounds[i].hits, before->samples->rounds[i].hits) << "round " << i;
  const auto history = live.snapshot().status.history;
  for (std::size_t i = 1; i < history.size(); ++i) EXPECT_GE(history[i].rays, history[i - 1].rays);
}

TEST(ProgressiveSession, another_error_counts_while_it_solves) {
  ProgressiveSession live(cornell, endless());
  ASSERT_TRUE(wait_until([&] { return !live.snapshot().status.history.empty(); }));
  live.set_error(0.02);
  ASSERT_TRUE(wait_for_idle(live));
  EXPECT_EQ(live.snapshot().status.stop, StopReason::error_reached);
  EXPECT_LE(live.snapshot().light->solution.predicted_error, 0.02);
}

TEST(ProgressiveSession, stops_and_keeps_its_light) {
  ProgressiveSession live(cornell, endless());
  ASSERT_TRUE(wait_until([&] { return live.snapshot().status.history.size() > 1; }));
  live.stop();
  ASSERT_TRUE(wait_for_idle(live));
  EXPECT_EQ(live.snapshot().status.stop, StopReason::stopped_by_user);
  EXPECT_TRUE(live.snapshot().light->is_last);
  EXPECT_TRUE(live.snapshot().status.can_relight);
}

TEST(ProgressiveSession, relights_in_proportion_and_back) {
  ProgressiveSession live(cornell, coarse());
  ASSERT_TRUE(wait_for_idle(live));
  const auto own = live.snapshot().light;
  const auto& patches = *own->mesh.patches;
  const auto bands = patches.band_count();
  Lighting lighting;
  lighting.lamps.assign(patches.group_count() * bands, 2.0f);
  live.relight(lighting);
  ASSERT_TRUE(wait_for_idle(live));
  EXPECT_EQ(live.snapshot().status.error_message, "");
  const auto twice = live.snapshot().light;
  EXPECT_TRUE(twice->is_relit);
  EXPECT_EQ(twice->mesh.geometry, own->mesh.geometry);
  ASSERT_EQ(front(twice).size(), front(own).size());
  const auto change = change_left(front(own));
  for (std::size_t i = 0; i < front(own).size(); ++i)
    EXPECT_NEAR(front(twice)[i], 2.0f * front(own)[i], change);

  lighting.reflectance.assign(patches.materials.size() * bands, 0.0f);
  live.relight(lighting);
  live.save_solution(fresh("relit.vtkhdf"));
  ASSERT_TRUE(wait_for_idle(live));
  for (std::size_t i = 0; i < front(own).size(); ++i)
    EXPECT_LE(front(live.snapshot().light)[i], front(twice)[i]);
  EXPECT_FALSE(read_stored_run(place("relit.vtkhdf")).samples);

  live.relight({});
  ASSERT_TRUE(wait_for_idle(live));
  EXPECT_EQ(front(live.snapshot().light), front(own));
}

TEST(ProgressiveSession, relights_while_it_solves) {
  ProgressiveSession live(cornell, endless());
  ASSERT_TRUE(wait_until([&] { return !live.snapshot().status.history.empty(); }));
  Lighting dark;
  dark.lamps.assign(live.snapshot().mesh->patches->group_count() * 3, 0.0f);
  live.relight(dark);
  ASSERT_TRUE(wait_until([&] { return live.snapshot().light->is_relit; }));
  EXPECT_FALSE(live.snapshot().status.is_idle);
  for (const auto H : front(live.snapshot().light)) EXPECT_EQ(H, 0.0f);
  const auto first = live.snapshot().light->number;
  ASSERT_TRUE(wait_until([&] { return live.snapshot().light->number > first; }));
  EXPECT_TRUE(live.snapshot().light->is_relit) << "the next answer is dark too";
  live.relight({});
  live.stop();
  ASSERT_TRUE(wait_for_idle(live));
  EXPECT_FALSE(live.snapshot().light->is_relit);
  const auto& H = front(live.snapshot().light);
  EXPECT_GT(*std::max_element(H.begin(), H.end()), 0.0f);
}

TEST(ProgressiveSession, opens_a_solution_and_relights_it_without_a_solve) {
  const auto file = fresh("kept.vtkhdf");
  {
    ProgressiveSession live(cornell, coarse());
    ASSERT_TRUE(wait_for_idle(live));
    live.close(file);
  }
  ProgressiveSession again(file, coarse());
  ASSERT_TRUE(wait_for_idle(again));
  const auto own = again.snapshot().light;
  EXPECT_EQ(own->solution.irradiance.front, read_solution(file).solution.irradiance.front);
  Lighting half;
  half.lamps.assign(own->mesh.patches->group_count() * 3, 0.5f);
  again.relight(half);
  ASSERT_TRUE(wait_for_idle(again));
  EXPECT_EQ(again.snapshot().status.error_message, "");
  const auto change = change_left(front(own));
  for (std::size_t i = 0; i < front(own).size(); ++i)
    EXPECT_NEAR(front(again.snapshot().light)[i], 0.5f * front(own)[i], change);
}

TEST(ProgressiveSession, shows_each_bounce_with_what_it_leaves_to_the_next) {
  auto settings = coarse();
  settings.light.method = Method::shooting;
  settings.light.shooting.rays = 20'000;
  settings.light.shooting.tolerance = 0.05;
  settings.begins_at_once = false;
  ProgressiveSession live(cornell, settings);
  ASSERT_TRUE(wait_for_idle(live));
  live.set_stepping(true);
  std::uint32_t bounces = 0;
  for (;; ++bounces) {
    live.step();
    ASSERT_TRUE(
        wait_until([&] { return live.snapshot().status.is_paused || live.snapshot().status.is_idle; }));
    if (live.snapshot().status.is_idle) break;
    const auto light = live.snapshot().light;
    EXPECT_NEAR(unshot_fraction(*light), light->solution.unshot_fraction, 1e-4) << "bounce " << bounces;
  }
  EXPECT_GT(bounces, 2u);
  EXPECT_EQ(live.snapshot().status.stop, StopReason::converged);
}

TEST(ProgressiveSession, dims_lamps_together_where_there_are_too_many_kinds) {
  const auto obj = fresh("lamps.obj");
  std::ofstream mtl(place("lamps.mtl"));
  std::ofstream file(obj);
  file << "mtllib luxel-live-lamps.mtl\nv 0 0 0\nv 80 0 0\nv 80 0 1\nusemtl floor\nf 1 3 2\n";
  mtl << "newmtl floor\nKd 0.5 0.5 0.5\n";
  for (int i = 0; i < 70; ++i) {
    mtl << "newmtl lamp" << i << "\nKd 0 0 0\nKe 1 1 1\n";
    file << "v " << i << " 1 0\nv " << i + 1 << " 1 0\nv " << i << " 1 1\nusemtl lamp" << i
         << "\nf -3 -2 -1\n";
  }
  mtl.close();
  file.close();
  auto settings = coarse();
  settings.patches.max_edge = no_max_edge;
  ProgressiveSession live(obj, settings);
  ASSERT_TRUE(wait_for_idle(live));
  EXPECT_EQ(live.snapshot().status.error_message, "");
  EXPECT_EQ(live.snapshot().mesh->patches->group_count(), 1u);
  const auto messages = live.snapshot().status.messages;
  EXPECT_TRUE(std::any_of(messages.begin(), messages.end(), [](const Message& m) {
    return m.text.find("all lamps are dimmed together") != std::string::npos;
  }));
}

TEST(ProgressiveSession, shows_the_bounces_of_its_samples) {
  ProgressiveSession live(cornell, coarse());
  ASSERT_TRUE(wait_for_idle(live));
  const auto own = live.snapshot().light;
  const auto after = [&](int bounces) {
    live.show_bounces(bounces);
    EXPECT_TRUE(wait_for_idle(live));
    EXPECT_EQ(live.snapshot().status.error_message, "");
    return live.snapshot().light;
  };
  for (const auto H : front(after(0))) EXPECT_EQ(H, 0.0f);
  const auto once = after(1);
  const auto& samples = *own->samples;
  for (std::size_t receiver = 0; receiver < samples.sides.size(); ++receiver) {
    if (samples.sides[receiver].is_back()) continue;
    double direct = 0.0;  // of the first band; one lamp is one group
    for (const auto& replicate : samples.direct) direct += static_cast<double>(replicate[3 * receiver]) / 8.0;
    EXPECT_NEAR(front(once)[3 * (samples.sides[receiver].patch())], direct, 1e-5);
  }
  for (const int bounces : {4, 2, 50}) {
    const auto light = after(bounces);
    EXPECT_EQ(light->bounces, bounces);
    EXPECT_NEAR(unshot_fraction(*light), light->solution.unshot_fraction, 1e-5);
  }
  for (std::size_t i = 0; i < front(own).size(); ++i)
    EXPECT_NEAR(front(live.snapshot().light)[i], front(own)[i], 1e-4f + 1e-4f * front(own)[i]);
  live.show_bounces({});
  ASSERT_TRUE(wait_for_idle(live));
  EXPECT_EQ(front(live.snapshot().light), front(own));
}

TEST(ProgressiveSession, compares_its_light_with_a_second_solution) {
  ProgressiveSession live(cornell, coarse());
  const auto file = fresh("second.vtkhdf");
  ASSERT_TRUE(wait_for_idle(live));
  live.save_solution(file);
  ASSERT_TRUE(wait_for_idle(live));
  live.compare_with(file);
  ASSERT_TRUE(wait_for_idle(live));
  ASSERT_TRUE(live.snapshot().difference);
  EXPECT_EQ(live.snapshot().difference->comparison.relative_rms, 0.0);
  Lighting twice;
  twice.lamps.assign(live.snapshot().mesh->patches->group_count() * 3, 2.0f);
  live.relight(twice);
  ASSERT_TRUE(wait_for_idle(live));
  EXPECT_EQ(live.snapshot().difference->light, live.snapshot().light->number);
  EXPECT_NEAR(live.snapshot().difference->comparison.relative_rms, 1.0, 1e-4);

  auto finer = coarse();
  finer.patches.max_edge = 0.3f;
  ProgressiveSession other(cornell, finer);
  other.compare_with(file);
  ASSERT_TRUE(wait_for_idle(other));
  EXPECT_FALSE(other.snapshot().difference);
  EXPECT_EQ(other.snapshot().status.errors, 1u);
}

TEST(ProgressiveSession, finds_faults_while_it_solves) {
  ProgressiveSession live(cornell, endless());
  live.request_diagnostics();
  ASSERT_TRUE(wait_until([&] { return live.snapshot().diagnostics != nullptr; }));
  EXPECT_FALSE(live.snapshot().status.is_idle);
  EXPECT_EQ(live.snapshot().diagnostics->triangles, live.snapshot().mesh->scene->triangles.size());
  EXPECT_EQ(live.snapshot().diagnostics->count(Severity::error), 0u);
}

}  // namespace
}  // namespace luxel
