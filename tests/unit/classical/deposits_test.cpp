// SPDX-License-Identifier: Apache-2.0
#include "luxel/classical/deposits.h"

#include <array>

#include <gtest/gtest.h>

namespace luxel {
namespace {

// Three bands at place i get 1, 10, 100 times the number of adds there.
void add_ten_each(Deposits& deposits, std::size_t places, std::size_t step, const Context& context) {
  const std::array<std::int64_t, 3> quantum = {1, 10, 100};
  context.for_chunks(10 * places, 100, [&](std::size_t begin, std::size_t end, int thread) {
    for (auto i = begin; i < end; ++i)
      if (i % places % step == 0) deposits.add(thread, i % places, quantum);
  });
}

void expect_ten_each(const Deposits::Sums& sums, std::size_t places, std::size_t step) {
  ASSERT_EQ(sums.place.size(), (places + step - 1) / step);
  ASSERT_EQ(sums.sum.size(), 3 * sums.place.size());
  for (std::size_t e = 0; e < sums.place.size(); ++e) {
    ASSERT_EQ(sums.place[e], e * step);
    ASSERT_EQ(sums.sum[3 * e], 10);
    ASSERT_EQ(sums.sum[3 * e + 1], 100);
    ASSERT_EQ(sums.sum[3 * e + 2], 1000);
  }
}

TEST(Deposits, sum_to_the_same_whether_counters_are_private_or_shared) {
  constexpr std::size_t places = 5000;
  for (const int threads : {1, 2, 5}) {
    const Context context(threads);
    Deposits deposits(places, 3, context);
    for (const std::uint64_t expected : {std::uint64_t{10}, std::uint64_t{1'000'000}, std::uint64_t{10}}) {
      deposits.expect(expected);
      EXPECT_EQ(deposits.is_private(), expected == 1'000'000);
      add_ten_each(deposits, places, 1, context);
      expect_ten_each(deposits.take(context), places, 1);
    }
  }
}

TEST(Deposits, tell_of_the_places_that_were_added_to_and_leave_nothing_behind) {
  constexpr std::size_t places = 50'001;
  const Context context(3);
  Deposits deposits(places, 3, context);
  for (const std::size_t step : {7u, 20'000u, 1u, 3u}) {
    deposits.expect(step == 7 ? 1'000'000'000 : 10);
    add_ten_each(deposits, places, step, context);
    expect_ten_each(deposits.take(context), places, step);
    EXPECT_TRUE(deposits.take(context).place.empty());
  }
}

TEST(Deposits, of_a_few_counters_are_always_private_so_that_none_is_a_hot_spot) {
  const Context context(3);
  Deposits deposits(1, 3, context);
  deposits.expect(1);
  EXPECT_TRUE(deposits.is_private());
  add_ten_each(deposits, 1, 1, context);
  expect_ten_each(deposits.take(context), 1, 1);
}

TEST(Deposits, that_would_not_fit_in_memory_as_copies_are_shared) {
  const Context context(8);
  constexpr std::size_t counters =
      Deposits::private_bytes / 8 / 8 + 1;  // a copy for each of eight: just too much
  Deposits deposits(counters, 1, context);
  deposits.expect(~std::uint64_t{0});
  EXPECT_FALSE(deposits.is_private());
}

}  // namespace
}  // namespace luxel
