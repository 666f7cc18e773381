// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/pool_units.h"

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace luxel {
namespace {

double sum_over(const std::vector<SeenUnit>& units, const std::vector<double>& density) {
  double sum = 0.0;
  for (std::size_t u = 0; u < units.size(); ++u) sum += density[u] * units[u].area;
  return sum;
}

TEST(PooledDensities, of_units_that_many_directions_met_are_their_own) {
  const std::vector<SeenUnit> units = {{1e5, 2e5, 1.0}, {4e5, 8e5, 2.0}, {0.0, 0.0, 1.0}, {1e5, 1e5, 0.5}};
  const auto density = pooled_densities(units);
  for (std::size_t u = 0; u < units.size(); ++u)
    EXPECT_NEAR(density[u], units[u].sum / units[u].area, 1e-4 * 4e5) << u;
}

// Poisson counts of one direction per unit on average, for one true density in each half: pooled, the units'
// squared errors are less than half of those of their own counts, and the sum stays.
TEST(PooledDensities, of_units_that_few_directions_met_are_near_those_of_their_neighbourhood) {
  std::mt19937 random(7);
  constexpr std::size_t count = 4096;
  std::vector<SeenUnit> units;
  std::vector<double> truth;
  for (std::size_t u = 0; u < count; ++u) {
    truth.push_back(u < count / 2 ? 0.5 : 1.5);
    const auto hits = static_cast<double>(std::poisson_distribution<int>(truth.back())(random));
    units.push_back({hits, hits, 1.0});
  }
  const auto density = pooled_densities(units);
  double own = 0.0, pooled = 0.0, hits = 0.0;
  for (std::size_t u = 0; u < count; ++u) {
    own += std::pow(units[u].sum - truth[u], 2);
    pooled += std::pow(density[u] - truth[u], 2);
    hits += units[u].hits;
  }
  EXPECT_LT(pooled, 0.5 * own);
  EXPECT_NEAR(sum_over(units, density), hits, 1e-6 * hits);
}

TEST(PooledDensities, of_nothing_seen_are_zero) {
  EXPECT_TRUE(pooled_densities({}).empty());
  const std::vector<SeenUnit> dark(5, {0.0, 0.0, 2.0});
  for (const auto density : pooled_densities(dark)) EXPECT_EQ(density, 0.0);
}

}  // namespace
}  // namespace luxel
