// SPDX-License-Identifier: Apache-2.0
#include "luxel/lighting/verdict.h"

#include <cmath>

#include <gtest/gtest.h>

#include "luxel/lighting/grid_figures.h"

namespace luxel {
namespace {

TEST(Verdict, is_made_on_the_whole_interval) {
  EXPECT_EQ(judge("Em", {510, 505, 515}, 500).compliance, Compliance::met);
  EXPECT_EQ(judge("Em", {490, 485, 495}, 500).compliance, Compliance::not_met);
  EXPECT_EQ(judge("Em", {501, 495, 507}, 500).compliance, Compliance::cannot_be_told);
  EXPECT_EQ(judge("Em", {500, 500, 500}, 500).compliance, Compliance::met);
  EXPECT_EQ(judge("d", {30, 25, 35}, 40, false).compliance, Compliance::met);
  EXPECT_EQ(judge("d", {50, 45, 55}, 40, false).compliance, Compliance::not_met);
  EXPECT_EQ(judge("d", {39, 35, 43}, 40, false).compliance, Compliance::cannot_be_told);
}

// The interval must shrink to a third: nine times the rays where all of the error is sampling.
TEST(Verdict, estimates_the_rays_that_tell) {
  const auto all = judge("Em", {502, 496, 508, 1.0, 1.0}, 500);
  ASSERT_TRUE(all.more_rays);
  EXPECT_NEAR(*all.more_rays, 9.0, 1e-9);
  EXPECT_FALSE(all.solution_factor);
  // Half of the variance is the solution's, of which a ninth would already be too much.
  const auto half = judge("Em", {502, 496, 508, 0.5, 0.5}, 500);
  EXPECT_FALSE(half.more_rays);
  ASSERT_TRUE(half.solution_factor);
  EXPECT_NEAR(*half.solution_factor, 1.0 / 3.0, 1e-9);
  // The upper end has another cause than the lower one.
  const auto upper = judge("Em", {498, 490, 504, 0.0, 1.0}, 500);
  EXPECT_NEAR(*upper.more_rays, 9.0, 1e-9);
  const auto on_it = judge("Em", {500, 490, 510}, 500);
  EXPECT_FALSE(on_it.more_rays || on_it.solution_factor);
}

TEST(Verdict, says_what_would_tell_and_what_all_are_together) {
  const auto met = judge("Em", {510, 505, 515}, 500), not_met = judge("Em", {490, 485, 495}, 500);
  auto open = judge("Em", {502, 496, 508, 1.0, 1.0}, 500), unknown = met;
  unknown.compliance = Compliance::not_known;
  EXPECT_EQ(remedy_of(met), "");
  EXPECT_NE(remedy_of(open).find("9 times as many rays"), std::string::npos) << remedy_of(open);
  EXPECT_FALSE(compliance_of(std::vector<Verdict>{}));
  EXPECT_EQ(compliance_of({met, met}), Compliance::met);
  EXPECT_EQ(compliance_of({met, unknown}), Compliance::not_known);
  EXPECT_EQ(compliance_of({unknown, open}), Compliance::cannot_be_told);
  EXPECT_EQ(compliance_of({unknown, open, not_met}), Compliance::not_met);
}

TEST(GridFigures, without_errors_are_exact) {
  const GridSamples samples{{300, 500, 400}, {0, 0, 0}, 7.0, {}, {}, 0.0};
  const GridFigures figures(samples);
  for (const auto& [figure, truth] : {std::pair{figures.mean(), 400.0},
                                      {figures.min(), 300.0},
                                      {figures.max(), 500.0},
                                      {figures.min_over_mean(), 0.75},
                                      {figures.min_over_max(), 0.6},
                                      {figures.max_over_min(), 5.0 / 3.0}}) {
    EXPECT_NEAR(figure.value, truth, 1e-12);
    EXPECT_EQ(figure.low, figure.high);
    EXPECT_NEAR(figure.low, truth, 1e-12);
  }
}

// A proportional error common to all points affects the mean, not the uniformity.
TEST(GridFigures, common_errors_cancel_in_the_uniformity) {
  GridSamples samples{{300, 500, 400}, {0, 0, 0}, 7.0, {}, {0, 0, 0}, 0.0};
  for (const double factor : {0.98, 1.0, 1.02, 0.99})
    samples.replicates.push_back({300 * factor, 500 * factor, 400 * factor});
  const GridFigures figures(samples);
  EXPECT_GT(figures.mean().high - figures.mean().low, 10.0);
  EXPECT_NEAR(figures.min_over_mean().high - figures.min_over_mean().low, 0.0, 1e-9);
  EXPECT_EQ(figures.mean().low_sampling, 0.0);
  // Four replicates: standard error of the factors is 0.0085391, Student's t for 3 degrees of
  // freedom 3.182446.
  EXPECT_NEAR(figures.mean().high, 400.0 * (1.0 + 3.182446 * 0.00853913), 1e-3);
}

TEST(GridFigures, a_dark_point_has_no_finite_ratio) {
  const GridSamples samples{{0, 10}, {0, 0}, 7.0, {}, {}, 0.0};
  EXPECT_TRUE(std::isinf(GridFigures(samples).max_over_min().value));
  EXPECT_EQ(GridFigures(samples).min_over_mean().value, 0.0);
}

}  // namespace
}  // namespace luxel
