// SPDX-License-Identifier: Apache-2.0
#include "luxel/core/discrete_distribution.h"

#include <gtest/gtest.h>

namespace luxel {
namespace {

TEST(DiscreteDistribution, numbers_fall_on_elements_in_proportion_to_their_weights) {
  DiscreteDistribution of;
  for (const auto weight : {1.0, 0.0, 2.0, 1.0}) of.add(weight);
  EXPECT_EQ(of.total(), 4.0);
  EXPECT_EQ(of.weight(2), 2.0);
  EXPECT_EQ(of.before(2), 1.0);
  EXPECT_EQ(of.choose(0.0), 0u);
  EXPECT_EQ(of.choose(0.2499), 0u);
  EXPECT_EQ(of.choose(0.25), 2u) << "an element without weight is never drawn";
  EXPECT_EQ(of.choose(0.7499), 2u);
  EXPECT_EQ(of.choose(0.75), 3u);
  EXPECT_EQ(of.at(of.total()), 3u) << "rounding may give the end";
}

TEST(DiscreteDistribution, normalised_weights_are_probabilities) {
  DiscreteDistribution of;
  for (const auto weight : {3.0, 0.0, 1.0}) of.add(weight);
  auto even = of;
  of.normalise();
  EXPECT_EQ(of.total(), 1.0);
  EXPECT_DOUBLE_EQ(of.weight(0), 0.75);
  EXPECT_EQ(of.weight(1), 0.0);
  even.normalise(0.3);
  EXPECT_EQ(even.total(), 1.0);
  EXPECT_DOUBLE_EQ(even.weight(0), 0.7 * 0.75 + 0.1);
  EXPECT_DOUBLE_EQ(even.weight(1), 0.1);
}

TEST(DiscreteDistribution, without_weight_all_are_as_probable) {
  DiscreteDistribution of;
  EXPECT_EQ(of.total(), 0.0);
  for (int i = 0; i < 4; ++i) of.add(0.0);
  of.normalise(0.02);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_DOUBLE_EQ(of.weight(i), 0.25);
}

}  // namespace
}  // namespace luxel
