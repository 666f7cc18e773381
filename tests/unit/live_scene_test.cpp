// SPDX-License-Identifier: Apache-2.0
// A scene that is solved in its own thread, as a window would use it.
#include "luxel/live/live_scene.h"

#include <chrono>
#include <fstream>
#include <functional>
#include <iterator>
#include <thread>

#include <gtest/gtest.h>

#include "luxel/solution/solution_file.h"
#include "luxel/solve/relight.h"

namespace luxel {
namespace {

const std::string cornell = LUXEL_SOURCE_DIR "/scenes/cornell-box.obj";

// A file of this test, not there yet.
std::filesystem::path fresh(const std::string& name) {
  const auto path = std::filesystem::path(testing::TempDir()) / ("luxel-live-" + name);
  std::filesystem::remove(path);
  return path;
}

std::string bytes(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

LiveSettings coarse() {
  LiveSettings settings;
  settings.patches.max_edge = 0.5f;
  settings.light.sampled.error = 0.05;
  return settings;
}

// Long enough for anything here on a slow machine.
bool wait_until(const std::function<bool()>& is_so) {
  for (int i = 0; i < 30'000; ++i) {
    if (is_so()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return false;
}
bool wait_for_idle(const LiveScene& scene) {
  return wait_until([&] { return scene.status().is_idle; });
}

TEST(LiveScene, ends_with_the_bytes_of_a_bake) {
  const auto settings = coarse();
  LiveScene live(cornell, settings);
  ASSERT_TRUE(wait_for_idle(live));
  EXPECT_EQ(live.status().error_message, "");
  EXPECT_EQ(live.status().stop, StopReason::error_reached);
  const auto file = fresh("same.vtkhdf");
  live.save_solution(file);
  ASSERT_TRUE(wait_for_idle(live));

  const Workers workers(1);
  const auto scene = load_scene(cornell);
  auto patches = make_patches(scene, settings.patches);
  set_light_groups(scene, {}, patches);
  const Tracer tracer(patches, workers);
  Solution solution;
  std::shared_ptr<const SampleState> samples;
  solve_sampled(patches, tracer, solution, settings.light.sampled, workers, {},
                {.from = {}, .keep = [&](auto state) { samples = state; }});
  const auto expected = fresh("expected.vtkhdf");
  samples = with_group_light(patches, tracer, samples, settings.light.sampled, workers);
  write_solution(expected, patches, solution, samples.get());
  EXPECT_EQ(bytes(file), bytes(expected));
}

TEST(LiveScene, says_in_a_sentence_what_is_wrong_with_a_file) {
  LiveScene missing("no-such-room.obj", coarse());
  ASSERT_TRUE(wait_for_idle(missing));
  EXPECT_NE(missing.status().error_message.find("no-such-room.obj"), std::string::npos);
  EXPECT_EQ(missing.mesh(), nullptr);

  const auto file = fresh("broken.vtkhdf");
  std::ofstream(file) << "no solution";
  LiveScene broken(file, coarse());
  ASSERT_TRUE(wait_for_idle(broken));
  EXPECT_NE(broken.status().error_message.find("broken.vtkhdf"), std::string::npos);
  broken.solve({});
  ASSERT_TRUE(wait_for_idle(broken));
  EXPECT_EQ(broken.status().errors, 2u);
}

}  // namespace
}  // namespace luxel
