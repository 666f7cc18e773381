// SPDX-License-Identifier: Apache-2.0
// A run that was stopped and resumed gives the same bytes as an uninterrupted one.
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "luxel/core/error.h"
#include "luxel/core/output_file.h"
#include "luxel/patch/make_patches.h"
#include "luxel/patch/side.h"
#include "luxel/solution/sample_state.h"
#include "luxel/solution/solution_file.h"
#include "luxel/solve/sampled.h"

#include "support/sample_solution.h"
#include "support/truth_scenes.h"

namespace luxel {
namespace {

namespace fs = std::filesystem;
using State = std::shared_ptr<const SampleState>;

// Enough receivers to share.
PatchSet room() { return make_patches(truth::l_room(), {.max_edge = 0.12f}); }
constexpr SampledOptions fine = {.error = 0.008};

struct Run {
  Solution solution;
  std::vector<State> states;  // one an answer
};

Run solve(const PatchSet& patches, const SampledOptions& options, int threads = 2, State from = nullptr) {
  const Context context(threads);
  const Tracer tracer(patches, context);
  Run run;
  const SolveHooks keeping{std::move(from), [&](State state) { run.states.push_back(std::move(state)); }};
  solve_sampled(patches, tracer, run.solution, options, keeping, context);
  return run;
}

fs::path file(const std::string& name) { return fs::path(testing::TempDir()) / ("luxel_resume_" + name); }

std::string bytes_of(const PatchSet& patches, const Run& run) {
  const auto path = file("bytes.vtkhdf");
  write_solution(path, patches, run.solution, run.states.back().get());
  return read_file(path);
}

TEST(Resume, from_every_doubling_gives_the_bytes_of_the_run_that_never_stopped) {
  const auto patches = room();
  ASSERT_GE(side_count(patches.size()), 4096u) << "neighbours do not share in so small a room";
  const auto whole = solve(patches, fine);
  ASSERT_GE(whole.states.size(), 3u);
  const auto expected = bytes_of(patches, whole);
  for (std::size_t i = 0; i < whole.states.size(); ++i) {
    // As a file, as a later process finds it.
    const auto path = file("state.vtkhdf");
    write_solution(path, patches, whole.solution, whole.states[i].get());
    const auto kept = read_stored_run(path);
    ASSERT_TRUE(kept.samples);
    const auto rest = solve(kept.baked.patches, fine, i % 2 == 0 ? 1 : 5, kept.samples);
    EXPECT_EQ(rest.states.size(), whole.states.size() - i);
    EXPECT_EQ(sample::difference(whole.solution, rest.solution), "") << "from answer " << i;
    EXPECT_EQ(bytes_of(patches, rest) == expected, true) << "from answer " << i;
  }
}

TEST(Resume, a_streamed_run_goes_on_as_a_stored_one_would) {
  const auto patches = make_patches(truth::l_room(), {.max_edge = 0.3f});
  const auto stored = solve(patches, {.error = 0.02});
  const auto streamed = solve(patches, {.error = 0.02, .memory = 1});
  ASSERT_GE(streamed.states.size(), 2u);
  EXPECT_FALSE(streamed.states[0]->rounds[0].hits);
  const auto rest = solve(patches, {.error = 0.02}, 2, streamed.states[0]);
  EXPECT_EQ(sample::difference(stored.solution, rest.solution), "");
}

TEST(Resume, with_light_groups_or_without_the_light_of_the_whole_is_the_same_to_rounding) {
  const auto patches = make_patches(truth::l_room(), {.max_edge = 0.3f});
  auto grouped = patches;
  grouped.light_groups = {"one", "none"};
  const auto plain = solve(patches, {.error = 0.02});
  const auto apart = solve(grouped, {.error = 0.02});
  ASSERT_EQ(plain.solution.irradiance.front.size(), apart.solution.irradiance.front.size());
  for (std::size_t i = 0; i < plain.solution.irradiance.front.size(); ++i)
    EXPECT_NEAR(plain.solution.irradiance.front[i], apart.solution.irradiance.front[i], 1e-5);
  EXPECT_EQ(apart.states[0]->direct[0].size(), 2 * plain.states[0]->direct[0].size());
}

// The error message for resuming from a wrong state.
std::string complaint(const PatchSet& patches, const SampleState& state, const SampledOptions& options = {}) {
  try {
    solve(patches, options, 2, std::make_shared<SampleState>(state));
  } catch (const MismatchError& error) {
    return error.what();
  }
  return {};
}

TEST(Resume, a_state_of_something_else_is_refused_in_a_sentence) {
  const auto patches = make_patches(truth::l_room(), {.max_edge = 0.3f});
  const auto run = solve(patches, {.error = 0.1});
  const auto& good = *run.states.back();
  EXPECT_EQ(complaint(patches, good), "");
  EXPECT_NE(complaint(make_patches(truth::cube_a(), {.max_edge = 0.3f}), good), "");
  EXPECT_NE(complaint(patches, good, {.replicates = 4}), "");
  const auto spoilt = [&](const auto& spoil) {
    auto state = good;
    spoil(state);
    return complaint(patches, state);
  };
  EXPECT_NE(spoilt([](SampleState& s) { s.sides.pop_back(); }), "");
  EXPECT_NE(spoilt([](SampleState& s) { s.sides[0] = SideId::at(none - 1); }), "");
  EXPECT_NE(spoilt([](SampleState& s) { s.rounds[0].receivers[0] = 0xfffffffeu; }), "");
  EXPECT_NE(spoilt([](SampleState& s) { s.rounds[0].level = 1; }), "");
  EXPECT_NE(spoilt([](SampleState& s) { s.rounds[0].per_replicate = 3; }), "");
  EXPECT_NE(spoilt([](SampleState& s) { s.direct.pop_back(); }), "");
  EXPECT_NE(spoilt([](SampleState& s) { s.direct[1].pop_back(); }), "");
  EXPECT_NE(spoilt([](SampleState& s) { s.direct_samples.pop_back(); }), "");
  EXPECT_NE(spoilt([](SampleState& s) { s.radiosity.pop_back(); }), "");
  EXPECT_NE(spoilt([](SampleState& s) {
              const auto count = s.replicates * s.rounds[0].hits_per_replicate();
              auto hits = std::make_shared<std::uint32_t[]>(count);
              std::copy_n(s.rounds[0].hits.get(), count, hits.get());
              hits[count / 2] = 0xfffffffeu;
              s.rounds[0].hits = hits;
            }),
            "");
}

TEST(Resume, a_stored_run_with_a_flipped_or_missing_byte_is_never_taken_for_another) {
  const auto patches = make_patches(truth::cube_a(), {.max_edge = 0.5f});
  const auto run = solve(patches, {.error = 0.2});
  const auto path = file("damaged.vtkhdf");
  write_solution(path, patches, run.solution, run.states.back().get());
  const auto whole = read_file(path);
  const auto expected = run.states.back()->direct;
  // The file is refused or reads as written, since some bytes have no meaning.
  const auto is_refused = [&](std::string_view bytes) {
    fs::remove(path);
    write_file(path, bytes);
    try {
      const auto kept = read_stored_run(path);
      EXPECT_TRUE(kept.samples && kept.samples->direct == expected);
      EXPECT_EQ(sample::difference(kept.baked.solution, run.solution), "");
    } catch (const FormatError&) {
      return true;
    }
    return false;
  };
  int refused = 0;
  for (std::size_t i = 0; i < whole.size(); i += whole.size() / 300) {
    SCOPED_TRACE(i);
    auto bytes = whole;
    bytes[i] = static_cast<char>(bytes[i] ^ (1 << (i % 8)));
    refused += is_refused(bytes) ? 1 : 0;
  }
  EXPECT_GT(refused, 200);
  for (std::size_t length = 0; length < whole.size(); length += whole.size() / 40) {
    SCOPED_TRACE(length);
    const bool is_whole = !is_refused(std::string_view(whole).substr(0, length));
    EXPECT_TRUE(!is_whole || whole.size() - length < 64);
  }
}

}  // namespace
}  // namespace luxel
