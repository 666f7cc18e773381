// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "luxel/patch/make_patches.h"
#include "luxel/patch/side.h"
#include "luxel/solve/sampled.h"

#include "support/truth_scenes.h"

namespace luxel::truth {
namespace {

constexpr std::size_t seeds = 16;
constexpr double rough = 0.05, accurate = rough / 10.0;

Solution solved(const PatchSet& patches, const Tracer& tracer, const SampledOptions& options,
                std::array<Solution, 2>* halves, const Context& context) {
  Solution solution;
  const auto report = solve_sampled(patches, tracer, solution, options, {.halves = halves}, context);
  EXPECT_EQ(report.stop, StopReason::error_reached);
  return solution;
}

// Sum over sides and bands of area * a * b.
template <typename A, typename B>
double area_product(const PatchSet& patches, A a, B b) {
  double sum = 0.0;
  const auto bands = patches.band_count();
  for (std::size_t s = 0; s < side_count(patches.size()); ++s) {
    const auto side = SideId::at(s);
    for (auto i = side.patch() * bands; i < (side.patch() + 1) * bands; ++i)
      sum += static_cast<double>(patches.area[side.patch()]) * a(side, i) * b(side, i);
  }
  return sum;
}

// The correlation of the errors of both halves is 0 within 0.02, the part that one half's noise reflects to
// the other, and four standard errors from the spread over seeds (risk 1e-3).
void expect_independent(const PatchSet& patches, bool smoothing) {
  const Context context(2);
  const Tracer tracer(patches, context);
  const auto truth =
      solved(patches, tracer,
             {.error = accurate, .error_measure = ErrorMeasure::power, .seed = 1000, .smoothing = false},
             nullptr, context);
  std::vector<double> correlation;
  for (std::size_t s = 0; s < seeds; ++s) {
    std::array<Solution, 2> halves;
    solved(patches, tracer,
           {.error = rough, .error_measure = ErrorMeasure::power, .seed = s + 1, .smoothing = smoothing},
           &halves, context);
    const auto error = [&](std::size_t half) {
      return [&, half](SideId side, std::size_t i) {
        return static_cast<double>(halves[half].irradiance.of(side)[i]) -
               static_cast<double>(truth.irradiance.of(side)[i]);
      };
    };
    correlation.push_back(
        area_product(patches, error(0), error(1)) /
        std::sqrt(area_product(patches, error(0), error(0)) * area_product(patches, error(1), error(1))));
  }
  const auto n = static_cast<double>(seeds);
  const auto mean = std::accumulate(correlation.begin(), correlation.end(), 0.0) / n;
  double squares = 0.0;
  for (const auto c : correlation) squares += (c - mean) * (c - mean);
  const auto standard_error = std::sqrt(squares / (n * (n - 1.0)));
  std::printf("correlation %.4f +- %.4f\n", mean, standard_error);
  EXPECT_NEAR(mean, 0.0, 0.02 + 4.0 * standard_error);
}

TEST(Halves, errors_are_independent) {
  expect_independent(make_patches(l_room(), {.max_edge = 0.2f}), false);
}

TEST(Halves, errors_of_smoothed_light_are_independent) {
  expect_independent(make_patches(cube_a(), {.max_edge = 0.06f}), true);
}

TEST(Halves, have_the_solution_as_their_mean) {
  const Context context(2);
  const auto patches = make_patches(l_room(), {.max_edge = 0.2f});
  const Tracer tracer(patches, context);
  std::array<Solution, 2> halves;
  const auto solution =
      solved(patches, tracer, {.error = rough, .error_measure = ErrorMeasure::power}, &halves, context);
  double largest = 0.0;
  for (const bool back : {false, true})
    for (std::size_t i = 0; i < solution.irradiance.of(back).size(); ++i) {
      const auto mean = 0.5f * (halves[0].irradiance.of(back)[i] + halves[1].irradiance.of(back)[i]);
      EXPECT_NEAR(mean, solution.irradiance.of(back)[i], 1e-5f * solution.irradiance.of(back)[i] + 1e-6f);
      largest = std::max(largest, static_cast<double>(solution.irradiance.of(back)[i]));
    }
  EXPECT_GT(largest, 0.0);
}

}  // namespace
}  // namespace luxel::truth
