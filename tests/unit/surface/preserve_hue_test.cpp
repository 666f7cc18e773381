// SPDX-License-Identifier: Apache-2.0
#include "luxel/surface/preserve_hue.h"

#include <vector>

#include <gtest/gtest.h>

namespace luxel {
namespace {

constexpr std::size_t bands = 3;

double power(const std::vector<float>& mean, const std::vector<float>& area, std::size_t band) {
  double sum = 0.0;
  for (std::size_t s = 0; s < area.size(); ++s) sum += static_cast<double>(area[s] * mean[s * bands + band]);
  return sum;
}

TEST(PreserveHue, a_channel_below_zero_takes_the_colour_of_its_neighbours_and_the_mean_stays) {
  const std::vector<float> area = {1.0f, 2.0f, 1.0f, 0.5f};
  const std::vector<float> given = {4.0f, 2.0f, 1.0f, 4.2f, 1.9f, 1.1f, 3.0f, -0.4f, 0.9f, 3.9f, 2.1f, 1.0f};
  auto mean = given;
  preserve_hue(mean, bands, area, std::vector<std::uint32_t>{0, 4});
  for (std::size_t b = 0; b < bands; ++b) EXPECT_NEAR(power(mean, area, b), power(given, area, b), 1e-5);
  // Green is 0.38 of red in the unit: about a quarter of that is left to it.
  EXPECT_GT(mean[7], 0.06f * mean[6]);
  // The others give what that took.
  for (const std::size_t i : {0u, 1u, 3u, 4u, 9u, 10u}) EXPECT_NEAR(mean[i], given[i], 0.1f * given[i]) << i;
}

TEST(PreserveHue, touches_no_unit_without_a_channel_below_zero) {
  const std::vector<float> area = {1.0f, 1.0f, 1.0f};
  std::vector<float> mean = {1.0f, 0.0f, 0.5f, 1.0f, 1.0f, 1.0f, 1.0f, 1.0f, -0.1f};
  const auto given = mean;
  preserve_hue(mean, bands, area, std::vector<std::uint32_t>{0, 2, 3});
  EXPECT_TRUE(std::equal(mean.begin(), mean.begin() + 6, given.begin()));
  for (const auto x : mean) EXPECT_GE(x, 0.0f);
}

TEST(PreserveHue, makes_a_unit_without_light_black) {
  const std::vector<float> area = {1.0f, 1.0f};
  std::vector<float> mean = {-1.0f, -2.0f, 0.0f, 0.5f, 0.5f, -1.0f};
  preserve_hue(mean, bands, area, std::vector<std::uint32_t>{0, 2});
  for (const auto x : mean) EXPECT_GE(x, 0.0f);
}

}  // namespace
}  // namespace luxel
