// SPDX-License-Identifier: Apache-2.0
// The test of error bars rejects wrong ones and accepts right ones: solutions are the truth plus noise of
// known size. Forty runs; the risks of a false alarm are below one in ten thousand per test.
#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "support/error_bars.h"

namespace luxel::truth {
namespace {

constexpr double noise = 0.03;  // relative, of every number

class ErrorJudge : public testing::Test {
 protected:
  // Runs with independent noise of `noise`; `wrong` may spoil each of them.
  std::vector<Solution> runs(const std::function<void(Solution&)>& wrong = {}) {
    std::mt19937_64 random(1);
    std::normal_distribution<double> normal;
    std::vector<Solution> all(40);
    for (auto& run : all) {
      for (const auto H : room_.truth.irradiance.front) {
        run.irradiance.front.push_back(static_cast<float>(H * (1.0 + noise * normal(random))));
        run.standard_error.front.push_back(static_cast<float>(noise * H));
      }
      run.irradiance.back.assign(run.irradiance.front.size(), 0.0f);
      run.standard_error.back.assign(run.irradiance.front.size(), 0.0f);
      run.predicted_error = noise;
      if (wrong) wrong(run);
    }
    return all;
  }

  KnownRoom room_ = open_plates();
};

TEST_F(ErrorJudge, passes_honest_error_bars) {
  const auto verdict = judge(room_, runs());
  EXPECT_NEAR(verdict.coverage.value, 0.95, 4.0 * verdict.coverage.standard_error);
  EXPECT_NEAR(verdict.coverage.standard_error, std::sqrt(0.95 * 0.05 / (768.0 * 40.0)), 5e-4);
  EXPECT_NEAR(verdict.ratio.value, 1.0, 4.0 * verdict.ratio.standard_error);
  EXPECT_LT(verdict.ratio.standard_error, 0.01);
  EXPECT_NEAR(verdict.bias.value, 0.0, 4.0 * verdict.bias.standard_error);
  EXPECT_NEAR(verdict.local_bias.value, 0.0, 4.0 * verdict.local_bias.standard_error);
  EXPECT_NEAR(stated_error(room_, runs()[0]), noise, 1e-3);
  EXPECT_NEAR(true_error(room_, runs()[0]), noise, 4e-3);
}

TEST_F(ErrorJudge, sees_error_bars_that_are_a_fifth_too_small_or_too_large) {
  const auto times = [](float factor) {
    return [factor](Solution& run) {
      for (auto& error : run.standard_error.front) error *= factor;
      run.predicted_error *= factor;
    };
  };
  EXPECT_LT(judge(room_, runs(times(0.8f))).coverage.value, 0.90);
  EXPECT_GT(judge(room_, runs(times(1.2f))).coverage.value, 0.975);
  EXPECT_NEAR(judge(room_, runs(times(0.8f))).ratio.value, 1.25, 0.05);
}

// The spread of eight numbers is itself uncertain: Student's t with seven degrees of freedom lies within 1.96
// in 90.9 % of cases, not 95. So the replicates of a single patch are not enough: the error bar must use its
// neighbours, or many replicates.
TEST_F(ErrorJudge, sees_that_eight_replicates_alone_make_a_wavering_error_bar) {
  std::mt19937_64 random(2);
  std::chi_squared_distribution<double> seven(7.0);
  const auto verdict = judge(room_, runs([&](Solution& run) {
                               for (auto& error : run.standard_error.front)
                                 error *= static_cast<float>(std::sqrt(seven(random) / 7.0));
                             }));
  EXPECT_NEAR(verdict.coverage.value, 0.9092, 4.0 * verdict.coverage.standard_error);
}

TEST_F(ErrorJudge, sees_light_that_is_too_much_by_a_tenth_of_the_noise) {
  const auto verdict = judge(room_, runs([](Solution& run) {
                               for (auto& H : run.irradiance.front) H *= 1.003f;
                             }));
  EXPECT_NEAR(verdict.bias.value, 0.003, 4.0 * verdict.bias.standard_error);
  EXPECT_GT(verdict.bias.value, 6.0 * verdict.bias.standard_error);
}

TEST_F(ErrorJudge, sees_a_bias_that_cancels_over_the_room) {
  const auto verdict = judge(room_, runs([](Solution& run) {
                               for (std::size_t i = 0; i < run.irradiance.front.size(); ++i)
                                 run.irradiance.front[i] *= (i / 3) % 2 == 0 ? 1.012f : 0.988f;
                             }));
  EXPECT_NEAR(verdict.bias.value, 0.0, 0.001);
  const auto fraction = 0.012 * 0.012 / (0.012 * 0.012 + noise * noise);
  EXPECT_NEAR(verdict.local_bias.value, fraction, 5.0 * verdict.local_bias.standard_error);
  EXPECT_GT(verdict.local_bias.value, 6.0 * verdict.local_bias.standard_error);
}

// An error common to all patches of a run widens the spread between runs, and so the judge's own error.
TEST_F(ErrorJudge, is_less_sure_of_runs_whose_patches_err_together) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  const auto alone = judge(room_, runs());
  const auto together = judge(room_, runs([&](Solution& run) {
                                const auto common = static_cast<float>(1.0 + noise * normal(random));
                                for (auto& H : run.irradiance.front) H *= common;
                                for (auto& error : run.standard_error.front) error *= std::sqrt(2.0f);
                                run.predicted_error *= std::sqrt(2.0);
                              }));
  EXPECT_GT(together.coverage.standard_error, 3.0 * alone.coverage.standard_error);
  EXPECT_NEAR(together.coverage.value, 0.95, 4.0 * together.coverage.standard_error);
  EXPECT_NEAR(together.ratio.value, 1.0, 4.0 * together.ratio.standard_error);
}

}  // namespace
}  // namespace luxel::truth
