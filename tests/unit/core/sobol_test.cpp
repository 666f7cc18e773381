// SPDX-License-Identifier: Apache-2.0
#include "luxel/core/sobol.h"

#include <array>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

namespace luxel {
namespace {

// Points first to first + count - 1 fall one each into the boxes of columns x rows = count.
bool is_net(const OwenSobol& sequence, std::uint32_t first, std::uint32_t count, std::uint32_t columns, int x,
            int y) {
  const auto rows = count / columns;
  std::set<std::uint32_t> boxes;
  for (auto i = first; i < first + count; ++i)
    boxes.insert(static_cast<std::uint32_t>(sequence.at(i, x) * static_cast<float>(columns)) * rows +
                 static_cast<std::uint32_t>(sequence.at(i, y) * static_cast<float>(rows)));
  return boxes.size() == count;
}

TEST(Sobol, aligned_blocks_are_nets_in_every_shape_of_box) {
  for (const std::uint64_t key : {1u, 2u, 77u})
    for (const std::uint32_t first : {0u, 64u, 7u * 64u, 64u * 100'003u})
      for (std::uint32_t columns = 1; columns <= 64; columns *= 2)
        EXPECT_TRUE(is_net(OwenSobol(key), first, 64, columns, 0, 1)) << first << " " << columns;
}

TEST(Sobol, every_dimension_alone_is_stratified) {
  const OwenSobol sequence(5);
  for (int d = 0; d < OwenSobol::dimensions; ++d)
    EXPECT_TRUE(is_net(sequence, 256, 256, 256, d, d == 0 ? 1 : 0)) << d;
}

// A pair of later dimensions has quality t > 0: boxes of 2^t points hold 2^t each.
TEST(Sobol, dimensions_two_and_three_fill_the_square) {
  const OwenSobol sequence(9);
  std::array<int, 16> count{};
  for (std::uint32_t i = 0; i < 256; ++i)
    ++count[static_cast<std::size_t>(sequence.at(i, 2) * 4.0f) * 4 +
            static_cast<std::size_t>(sequence.at(i, 3) * 4.0f)];
  for (const auto c : count) EXPECT_EQ(c, 16);
}

// One fixed index over 10,000 keys: uniform, and dimensions independent. Five standard errors: risk 6e-7
// each.
TEST(Sobol, each_point_is_uniform_over_the_scramblings) {
  for (const std::uint32_t index : {0u, 1u, 5u, 123'456u}) {
    constexpr int n = 10'000;
    std::array<double, OwenSobol::dimensions> sum{};
    double square = 0.0;
    double product = 0.0;
    for (std::uint64_t key = 0; key < n; ++key) {
      const OwenSobol sequence(mix64(key));
      for (int d = 0; d < OwenSobol::dimensions; ++d)
        sum[static_cast<std::size_t>(d)] += static_cast<double>(sequence.at(index, d)) - 0.5;
      const auto x = static_cast<double>(sequence.at(index, 0)) - 0.5;
      square += x * x;
      product += x * (static_cast<double>(sequence.at(index, 1)) - 0.5);
    }
    for (const auto s : sum) EXPECT_LT(std::abs(s / n), 5.0 * std::sqrt(1.0 / 12.0 / n));
    EXPECT_NEAR(square / n, 1.0 / 12.0, 5.0 * std::sqrt(1.0 / 180.0 / n));
    EXPECT_LT(std::abs(product / n), 5.0 / 12.0 / std::sqrt(static_cast<double>(n)));
  }
}

// The mean of x y over 1,024 points errs by 0.0069 with independent numbers; RMS over 100 keys.
TEST(Sobol, a_smooth_mean_errs_far_less_than_with_independent_numbers) {
  double square = 0.0;
  for (std::uint64_t key = 0; key < 100; ++key) {
    const OwenSobol sequence(mix64(key));
    double sum = 0.0;
    for (std::uint32_t i = 0; i < 1024; ++i)
      sum += static_cast<double>(sequence.at(i, 0)) * static_cast<double>(sequence.at(i, 1));
    square += (sum / 1024.0 - 0.25) * (sum / 1024.0 - 0.25);
  }
  EXPECT_LT(std::sqrt(square / 100.0), 0.0069 / 50.0);
}

}  // namespace
}  // namespace luxel
