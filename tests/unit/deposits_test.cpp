// SPDX-License-Identifier: Apache-2.0
#include "luxel/transport/deposits.h"

#include <array>

#include <gtest/gtest.h>

namespace luxel {
namespace {

// Three bands at place i get 1, 10, 100 times the number of adds there.
std::vector<std::int64_t> filled(std::size_t places, std::uint64_t expected_adds, int threads,
                                 bool& is_private) {
  const Workers workers(threads);
  Deposits deposits(3 * places, expected_adds, workers);
  is_private = deposits.is_private();
  const std::array<std::int64_t, 3> quantum = {1, 10, 100};
  workers.for_chunks(10 * places, 100, [&](std::size_t begin, std::size_t end, int worker) {
    for (auto i = begin; i < end; ++i) deposits.add(worker, 3 * (i % places), quantum);
  });
  return deposits.take_total(workers);
}

TEST(Deposits, sum_to_the_same_whether_counters_are_private_or_shared) {
  constexpr std::size_t places = 5000;
  for (const int threads : {1, 2, 5}) {
    for (const std::uint64_t expected : {std::uint64_t{10}, std::uint64_t{1'000'000}}) {
      bool is_private = false;
      const auto sums = filled(places, expected, threads, is_private);
      EXPECT_EQ(is_private, expected == 1'000'000);
      ASSERT_EQ(sums.size(), 3 * places);
      for (std::size_t i = 0; i < places; ++i) {
        ASSERT_EQ(sums[3 * i], 10);
        ASSERT_EQ(sums[3 * i + 1], 100);
        ASSERT_EQ(sums[3 * i + 2], 1000);
      }
    }
  }
}

TEST(Deposits, of_a_few_counters_are_always_private_so_that_none_is_a_hot_spot) {
  bool is_private = false;
  EXPECT_EQ(filled(1, 1, 3, is_private), (std::vector<std::int64_t>{10, 100, 1000}));
  EXPECT_TRUE(is_private);
}

TEST(Deposits, that_would_not_fit_in_memory_as_copies_are_shared) {
  const Workers workers(8);
  constexpr std::size_t counters =
      Deposits::private_bytes / 8 / 8 + 1;  // a copy for each of eight: just too much
  EXPECT_FALSE(Deposits(counters, ~std::uint64_t{0}, workers).is_private());
}

}  // namespace
}  // namespace luxel
