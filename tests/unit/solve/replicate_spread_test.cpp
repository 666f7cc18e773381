// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/replicate_spread.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "luxel/core/address.h"

namespace luxel {
namespace {

using Values = std::vector<std::vector<float>>;

Values random_values(std::size_t replicates, std::size_t numbers, std::uint64_t seed) {
  Values values(replicates, std::vector<float>(numbers));
  for (std::uint32_t r = 0; r < replicates; ++r)
    for (std::size_t i = 0; i < numbers; ++i)
      values[r][i] = uniform4({seed, r, static_cast<std::uint32_t>(i), 0})[0];
  return values;
}

TEST(ReplicateSpread, of_known_numbers_is_known) {
  // One receiver of two bands: 1 to 8, whose mean is 4.5 and the variance of that 6 / 8; and always 2.
  Values values;
  for (int r = 1; r <= 8; ++r) values.push_back({static_cast<float>(r), 2.0f});
  const std::vector<float> bias = {0.25f, -0.01f};
  const std::vector<float> area = {0.5f};
  const auto spread = spread_of(values, {bias, 2, area}, Context(2));
  EXPECT_EQ(spread.mean, (std::vector<float>{4.5f, 2.0f}));
  // Student's t with 7 degrees of freedom: 2.36462 for 1.95996.
  EXPECT_NEAR(spread.standard_error[0], std::sqrt(0.75 + 0.25) * 2.36462 / 1.95996, 2e-3);
  EXPECT_EQ(spread.standard_error[1], 0.0f);
  EXPECT_NEAR(spread.total_squared_error, 0.5 * (0.75 + 0.25 - 0.01), 1e-7);
  EXPECT_NEAR(spread.total_squared_light, 0.5 * (4.5 * 4.5 + 4.0), 1e-12);
}

TEST(ReplicateSpread, a_bias_below_nothing_takes_nothing_off_the_noise) {
  const Values values = {{1.0f}, {2.0f}, {3.0f}, {4.0f}};
  const auto spread = spread_of(values, {std::vector<float>{-5.0f}, 1, std::vector<float>{2.0f}}, Context(1));
  EXPECT_NEAR(spread.total_squared_error, 2.0 * (5.0 / 3.0) / 4.0, 1e-7);
}

TEST(ReplicateSpread, of_the_dark_is_nothing) {
  const Values values(4, std::vector<float>(30, 0.0f));
  const auto spread =
      spread_of(values, {std::vector<float>(30, 0.0f), 3, std::vector<float>(10, 1.0f)}, Context(2));
  EXPECT_EQ(spread.total_squared_error, 0.0);
  EXPECT_EQ(spread.total_squared_light, 0.0);
}

TEST(ReplicateSpread, of_a_sum_is_that_of_the_numbers_added) {
  constexpr std::size_t receivers = 10'000;
  const auto first = random_values(5, 3 * receivers, 1);
  const auto second = random_values(5, 3 * receivers, 2);
  auto sum = first;
  for (std::size_t r = 0; r < 5; ++r)
    for (std::size_t i = 0; i < 3 * receivers; ++i) sum[r][i] += second[r][i];
  const std::vector<float> bias(3 * receivers, 1e-3f);
  const std::vector<float> area(receivers, 0.1f);
  const Context context(2);
  const auto expected = spread_of(sum, {bias, 3, area}, context);
  const auto spread = spread_of_sum(first, second, {bias, 3, area}, context);
  EXPECT_EQ(spread.mean, expected.mean);
  EXPECT_EQ(spread.standard_error, expected.standard_error);
  EXPECT_EQ(spread.total_squared_error, expected.total_squared_error);
}

TEST(ReplicateSpread, squared_errors_alone_are_those_of_the_whole) {
  constexpr std::size_t receivers = 5000;
  const auto values = random_values(8, 3 * receivers, 1);
  const std::vector<float> area(receivers, 0.1f);
  const Context context(2);
  const auto spread = spread_of(values, {std::vector<float>(3 * receivers, 0.0f), 3, area}, context);
  const auto total_squared_error = squared_errors(values, 3, context);
  EXPECT_NEAR(0.1f * std::accumulate(total_squared_error.begin(), total_squared_error.end(), 0.0),
              spread.total_squared_error, 1e-9 * receivers);
}

TEST(ReplicateSpread, has_the_same_bits_on_any_number_of_threads) {
  constexpr std::size_t receivers = 300'000;
  const auto values = random_values(4, receivers, 1);
  const std::vector<float> bias(receivers, 1e-3f);
  const std::vector<float> area(receivers, 0.1f);
  const auto one = spread_of(values, {bias, 1, area}, Context(1));
  for (const int threads : {2, 5}) {
    const auto spread = spread_of(values, {bias, 1, area}, Context(threads));
    EXPECT_EQ(spread.standard_error, one.standard_error);
    EXPECT_EQ(spread.total_squared_error, one.total_squared_error);
    EXPECT_EQ(spread.total_squared_light, one.total_squared_light);
  }
}

}  // namespace
}  // namespace luxel
