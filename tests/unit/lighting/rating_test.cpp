// SPDX-License-Identifier: Apache-2.0
#include "luxel/lighting/rating.h"

#include <vector>

#include <gtest/gtest.h>

#include "luxel/lighting/replicate_figure.h"

namespace luxel {
namespace {

TEST(Rating, leed_has_one_two_and_three_points) {
  EXPECT_EQ(leed_points(0.399), 0);
  EXPECT_EQ(leed_points(0.40), 1);
  EXPECT_EQ(leed_points(0.55), 2);
  EXPECT_EQ(leed_points(0.75), 3);
}

TEST(Rating, the_whole_interval_decides) {
  EXPECT_EQ(judged({0.5, 0.5, 0.5}, 0.5), Compliance::met);
  EXPECT_EQ(judged({0.6, 0.51, 0.7}, 0.5), Compliance::met);
  EXPECT_EQ(judged({0.6, 0.49, 0.7}, 0.5), Compliance::cannot_be_told);
  EXPECT_EQ(judged({0.4, 0.3, 0.499}, 0.5), Compliance::not_met);
  EXPECT_EQ(both(Compliance::met, Compliance::cannot_be_told), Compliance::cannot_be_told);
  EXPECT_EQ(both(Compliance::cannot_be_told, Compliance::not_met), Compliance::not_met);
  EXPECT_EQ(both(Compliance::met, Compliance::met), Compliance::met);
}

// Rounding is no error: a figure on the limit meets it.
TEST(Rating, equal_replicates_have_no_interval) {
  const std::vector<double> same(8, 0.4);
  const auto figure = jackknifed(0.4, same);
  EXPECT_EQ(figure.low, 0.4);
  EXPECT_EQ(figure.high, 0.4);
  EXPECT_EQ(judged(figure, 0.4), Compliance::met);
  // Twice the distance, twice the interval.
  const std::vector<double> two = {0.0, 1.0};
  EXPECT_NEAR((jackknifed(0.5, two).high - 0.5) / (jackknifed(0.5, std::vector<double>{0.0, 0.5}).high - 0.5),
              2.0, 1e-12);
}

TEST(Rating, en_17037_needs_half_and_95_per_cent) {
  ClimateProvision p;
  p.points_on_target = {0.5, 0.5, 0.5};
  p.points_on_minimum = {0.94, 0.94, 0.94};
  EXPECT_EQ(compliance_by_points(p), Compliance::not_met);
  p.points_on_minimum = {0.96, 0.95, 0.97};
  EXPECT_EQ(compliance_by_points(p), Compliance::met);
  p.hours_on_target = {0.7, 0.7, 0.7};
  p.hours_on_minimum = {0.5, 0.49, 0.51};
  EXPECT_EQ(compliance_by_hours(p), Compliance::cannot_be_told);
  YearReport year;
  year.hours_mean_300 = {2500.0, 2400.0, 2600.0};
  year.hours_min_90 = {2000.0, 2000.0, 2000.0};
  EXPECT_EQ(breeam_compliance(year), Compliance::met);
  year.hours_min_90 = {1900.0, 1890.0, 1910.0};
  EXPECT_EQ(breeam_compliance(year), Compliance::not_met);
}

TEST(Rating, leed_needs_an_explanation_where_the_whole_interval_is_above_10_per_cent) {
  EXPECT_EQ(leed_exposure_compliance({0.1, 0.1, 0.1}), Compliance::met);
  EXPECT_EQ(leed_exposure_compliance({0.11, 0.105, 0.115}), Compliance::not_met);
  EXPECT_EQ(leed_exposure_compliance({0.11, 0.1, 0.12}), Compliance::cannot_be_told);
}

}  // namespace
}  // namespace luxel
