// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <stdexcept>

#include <gtest/gtest.h>

#include "luxel/classical/stochastic_jacobi.h"
#include "luxel/patch/make_patches.h"

#include "support/truth_scenes.h"

namespace luxel {
namespace {

Solution solve_with(int threads, float max_edge, std::uint64_t seed) {
  const Context context(threads);
  const auto patches = make_patches(truth::l_room(), {.max_edge = max_edge});
  const Tracer tracer(patches, context);
  Solution solution;
  solve_stochastic_jacobi(patches, tracer, solution, {.rays = 300'000, .seed = seed}, context);
  return solution;
}

// Both ways of counting: private counters (few patches) and shared ones (many).
TEST(Threads, one_two_and_seven_give_identical_bytes) {
  for (const float edge : {0.5f, 0.04f}) {
    const auto one = solve_with(1, edge, 1);
    for (const int threads : {2, 7}) {
      const auto many = solve_with(threads, edge, 1);
      EXPECT_EQ(one.irradiance.front, many.irradiance.front) << threads << " threads, edge " << edge;
      EXPECT_EQ(one.irradiance.back, many.irradiance.back);
      EXPECT_EQ(one.radiosity.front, many.radiosity.front);
      EXPECT_EQ(one.predicted_error, many.predicted_error);
      EXPECT_EQ(one.provenance.rays, many.provenance.rays);
    }
  }
}

TEST(Threads, the_number_asked_for_is_the_number_there_is) {
  EXPECT_EQ(Context(7).threads(), 7);
  EXPECT_GE(Context().threads(), 1);
}

TEST(Threads, another_seed_gives_another_answer) {
  EXPECT_NE(solve_with(2, 0.5f, 1).irradiance.front, solve_with(2, 0.5f, 2).irradiance.front);
}

TEST(Threads, chunks_cover_every_index_once_and_errors_come_back) {
  const Context context(3);
  std::vector<int> seen(10'001, 0);
  context.for_chunks(seen.size(), 97, [&](std::size_t begin, std::size_t end, int thread) {
    EXPECT_GE(thread, 0);
    EXPECT_LT(thread, 3);
    for (auto i = begin; i < end; ++i) ++seen[i];
  });
  EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), static_cast<std::ptrdiff_t>(seen.size()));
  EXPECT_THROW(
      context.for_chunks(10, 1, [](std::size_t, std::size_t, int) { throw std::runtime_error("no"); }),
      std::runtime_error);
}

TEST(Threads, an_ordered_sum_has_the_same_bits_for_any_number_of_them) {
  const auto term = [](std::size_t i) { return 1.0 / static_cast<double>(i + 1); };
  const auto one = ordered_sum(Context(1), 100'000, term);
  EXPECT_EQ(one, ordered_sum(Context(2), 100'000, term));
  EXPECT_EQ(one, ordered_sum(Context(5), 100'000, term));
  EXPECT_NEAR(one, 12.090146129863428, 1e-12);  // the harmonic number H(100000)
}

}  // namespace
}  // namespace luxel
