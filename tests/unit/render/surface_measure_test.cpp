// SPDX-License-Identifier: Apache-2.0
// Illuminance of surfaces: exact values, intervals by hand, and their coverage.
#include "luxel/render/surface_measure.h"

#include <cmath>

#include <gtest/gtest.h>

#include "luxel/core/address.h"
#include "luxel/core/student.h"
#include "luxel/core/student_quantile.h"

#include "support/lit_patches.h"

namespace luxel {
namespace {

using test::LitPatches;

constexpr double efficacy = 179.0;  // lm/W of light that is the same in all bands

// Triangles of 1, 2 and 1 m² with 10, 20 and 40 W/m² on their fronts and 1, 2 and 3 on their backs.
LitPatches three() {
  LitPatches lit;
  const auto triangle = [&](float x, float width, float front, float back) {
    const auto a = lit.vertex({x, 0, 0}), b = lit.vertex({x + width, 0, 0}), c = lit.vertex({x, 2, 0});
    lit.patch({a, b, c}, front, back);
  };
  triangle(0, 1, 10, 1);
  triangle(1, 2, 20, 2);
  triangle(3, 1, 40, 3);
  return lit;
}

const std::vector<std::uint32_t> all_three = {0, 1, 2};

void set_errors(LitPatches& lit, const std::array<float, 3>& error, double freedom) {
  for (const auto e : error)
    for (int b = 0; b < 3; ++b) {
      lit.solution.standard_error.front.push_back(e);
      lit.solution.standard_error.back.push_back(e);
    }
  lit.solution.error_degrees_of_freedom = freedom;
}

TEST(SurfaceMeter, has_the_numbers_of_a_surface) {
  const auto lit = three();
  const SurfaceMeter meter(lit.patches, lit.solution, {});
  const auto m = meter.measure(all_three, SurfaceSide::automatic);
  EXPECT_FALSE(m.back);
  EXPECT_EQ(m.patches, 3u);
  EXPECT_NEAR(m.area, 4.0, 1e-6);
  EXPECT_NEAR(m.mean.value, efficacy * 22.5, 1e-3);
  EXPECT_NEAR(m.min.value, efficacy * 10.0, 1e-3);
  EXPECT_NEAR(m.max.value, efficacy * 40.0, 1e-3);
  EXPECT_NEAR(m.min_over_mean.value, 10.0 / 22.5, 1e-6);
  EXPECT_NEAR(m.min_over_max.value, 0.25, 1e-6);
  EXPECT_EQ(m.darkest, 0u);
  EXPECT_EQ(m.brightest, 2u);
  // Without errors there are no intervals.
  EXPECT_EQ(meter.errors_of_means(), SolutionErrors::not_stated);
  EXPECT_EQ(m.mean.low, m.mean.high);
  EXPECT_EQ(m.min.low, m.min.value);
  EXPECT_EQ(m.max.high, m.max.value);
}

TEST(SurfaceMeter, takes_the_side_that_is_named_or_receives_more) {
  auto lit = three();
  const SurfaceMeter meter(lit.patches, lit.solution, {});
  EXPECT_NEAR(meter.measure(all_three, SurfaceSide::back).mean.value, efficacy * 2.0, 1e-3);
  for (std::size_t i = 0; i < 9; ++i) lit.solution.irradiance.back[i] *= 100.0f;
  EXPECT_TRUE(meter.measure(all_three, SurfaceSide::automatic).back);
  EXPECT_FALSE(meter.measure(all_three, SurfaceSide::front).back);
  const std::vector<std::uint32_t> one = {1};
  EXPECT_NEAR(meter.measure(one, SurfaceSide::front).mean.value, efficacy * 20.0, 1e-3);
}

// Such as the floor below a cabinet.
TEST(SurfaceMeter, leaves_out_what_no_light_reaches) {
  auto lit = three();
  for (std::size_t b = 0; b < 3; ++b) lit.solution.irradiance.front[b] = 0.0f;
  const SurfaceMeter meter(lit.patches, lit.solution, {});
  const auto m = meter.measure(all_three, SurfaceSide::front);
  EXPECT_EQ(m.patches, 2u);
  EXPECT_NEAR(m.area, 3.0, 1e-6);
  EXPECT_NEAR(m.unlit, 1.0, 1e-6);
  EXPECT_NEAR(m.min.value, efficacy * 20.0, 1e-3);
  EXPECT_NEAR(m.mean.value, efficacy * 80.0 / 3.0, 1e-3);
  EXPECT_EQ(m.darkest, 1u);
}

TEST(SurfaceMeter, a_dark_surface_has_no_uniformity) {
  auto lit = three();
  for (auto& v : lit.solution.irradiance.back) v = 0.0f;
  const SurfaceMeter meter(lit.patches, lit.solution, {});
  const auto m = meter.measure(all_three, SurfaceSide::back);
  EXPECT_EQ(m.mean.value, 0.0);
  EXPECT_NEAR(m.area, 4.0, 1e-6);
  EXPECT_EQ(m.unlit, 0.0);
  EXPECT_EQ(m.min_over_mean.value, 0.0);
}

// Stored standard errors are widened; 1.96 of them are the interval of a single number.
TEST(SurfaceMeter, forms_intervals_from_the_errors_of_patches) {
  auto lit = three();
  set_errors(lit, {1.0f, 0.5f, 2.0f}, 7.0);
  const SurfaceMeter meter(lit.patches, lit.solution, {});
  EXPECT_EQ(meter.errors_of_means(), SolutionErrors::patches);
  const auto m = meter.measure(all_three, SurfaceSide::front);
  const auto t = student_quantile(0.025, 7.0) / student_widening(7.0);
  const auto corrected = student_quantile(0.025 / 3.0, 7.0) / student_widening(7.0);
  EXPECT_NEAR(t, 1.96, 0.02);
  EXPECT_NEAR(m.mean.low, efficacy * (22.5 - t * 1.0), 1e-3);  // (1 + 2 x 0.5 + 2) / 4
  EXPECT_NEAR(m.mean.high, efficacy * (22.5 + t * 1.0), 1e-3);
  EXPECT_NEAR(m.min.low, efficacy * (10.0 - t), 1e-3);
  EXPECT_NEAR(m.min.high, efficacy * (10.0 + corrected), 1e-3);
  EXPECT_NEAR(m.max.low, efficacy * (40.0 - corrected * 2.0), 1e-3);
  EXPECT_NEAR(m.max.high, efficacy * (40.0 + t * 2.0), 1e-3);
  EXPECT_LT(m.min_over_mean.low, m.min.low / m.mean.high) << "each end has half of the risk";
  EXPECT_GT(m.min_over_mean.high, m.min.high / m.mean.low);
}

TEST(SurfaceMeter, forms_the_interval_of_a_mean_from_replicates) {
  auto lit = three();
  set_errors(lit, {1.0f, 1.0f, 1.0f}, 7.0);
  std::vector<std::vector<float>> replicates;
  for (const auto shift : {-3.0f, -1.0f, 1.0f, 3.0f}) {
    std::vector<float> lux;
    for (const auto h : {10.0f, 20.0f, 40.0f}) {
      lux.push_back(179.0f * h + shift);
      lux.push_back(0.0f);
    }
    replicates.push_back(lux);
  }
  const SurfaceMeter meter(lit.patches, lit.solution, replicates);
  EXPECT_EQ(meter.errors_of_means(), SolutionErrors::replicates);
  const auto m = meter.measure(all_three, SurfaceSide::front);
  const auto error = std::sqrt(20.0 / (4.0 * 3.0));
  EXPECT_NEAR(m.mean.high - m.mean.value, student_quantile(0.025, 3.0) * error, 0.01);
  EXPECT_NEAR(m.mean.value - m.mean.low, student_quantile(0.025, 3.0) * error, 0.01);
}

// Forty patches of which eight are equally dark, the worst case of a minimum; errors of known size,
// independent of each other. 1500 trials: were the coverage 95 %, fewer than 93 % would contain the truth
// with a chance of 2e-4.
TEST(SurfaceMeter, the_intervals_of_extremes_and_uniformities_contain_the_truth) {
  constexpr int patches = 40, trials = 1500;
  LitPatches truth;
  std::vector<std::uint32_t> selected;
  for (int i = 0; i < patches; ++i) {
    const auto x = static_cast<float>(i);
    const auto a = truth.vertex({x, 0, 0}), b = truth.vertex({x + 1, 0, 0}), c = truth.vertex({x, 2, 0});
    selected.push_back(static_cast<std::uint32_t>(
        truth.patch({a, b, c}, i < 8 ? 10.0f : 10.0f + static_cast<float>(i % 5))));
  }
  const auto exact = SurfaceMeter(truth.patches, truth.solution, {}).measure(selected, SurfaceSide::front);
  const auto normal = [](std::uint64_t n) {
    double sum = 0.0;  // of twelve uniform numbers: normal enough
    for (std::uint64_t k = 0; k < 3; ++k)
      for (const auto u : uniform4(mix64(n), k)) sum += static_cast<double>(u);
    return static_cast<float>(sum - 6.0);
  };
  int min = 0, max = 0, ratio = 0;
  for (int trial = 0; trial < trials; ++trial) {
    auto lit = truth;
    for (int i = 0; i < patches; ++i)
      for (int b = 0; b < 3; ++b) {
        const auto at = static_cast<std::size_t>(3 * i + b);
        lit.solution.irradiance.front[at] += 0.5f * normal(static_cast<std::uint64_t>(trial * patches + i));
        lit.solution.standard_error.front.push_back(0.5f);
        lit.solution.standard_error.back.push_back(0.5f);
      }
    const auto m = SurfaceMeter(lit.patches, lit.solution, {}).measure(selected, SurfaceSide::front);
    const auto holds = [](const MeasuredNumber& n, const MeasuredNumber& of) {
      return n.low <= of.value && of.value <= n.high ? 1 : 0;
    };
    min += holds(m.min, exact.min);
    max += holds(m.max, exact.max);
    ratio += holds(m.min_over_mean, exact.min_over_mean);
  }
  EXPECT_GE(min, 0.93 * trials);
  EXPECT_GE(max, 0.93 * trials);
  EXPECT_GE(ratio, 0.93 * trials);
  EXPECT_LT(min + max + ratio, 3 * trials) << "intervals that always hold are too wide to mean anything";
}

}  // namespace
}  // namespace luxel
