// SPDX-License-Identifier: Apache-2.0
// Standard errors of view factors are true, and enforced laws bring factors nearer to the truth. Each figure
// is a mean over 60 seeds of a cube's 30 factors, whose truth is known; a ratio of variances has a standard
// error near 5 %, and four of these are allowed: a false alarm once in ten thousand.
#include <cmath>

#include <gtest/gtest.h>

#include "luxel/form_factors/enforce.h"

#include "support/factor_scenes.h"

namespace luxel::truth {
namespace {

constexpr int seeds = 60;

// Sums over the factors of one run.
struct Errors {
  double squares = 0.0, expected = 0.0, sum = 0.0;
  std::size_t count = 0;

  void add(const ViewFactors& factors, const ViewFactors& truth) {
    for (std::size_t i = 0; i < truth.size(); ++i)
      for (std::size_t j = 0; j < truth.size(); ++j) {
        const auto a = factor(factors, i, j);
        const auto error = a.value - factor(truth, i, j).value;
        squares += error * error;
        expected += a.standard_error * a.standard_error;
        sum += error;
        ++count;
      }
  }
};

TEST(ViewFactorErrors, are_as_large_as_they_say) {
  const FactorScene cube(cube_a(), Between::materials);
  const auto truth = cube.exact();
  Errors errors;
  for (int seed = 1; seed <= seeds; ++seed)
    errors.add(cube.counted({.seed = static_cast<std::uint64_t>(seed), .rays = 512, .error = 0.0}), truth);
  EXPECT_NEAR(errors.squares / errors.expected, 1.0, 0.2);
}

TEST(ViewFactorErrors, shrink_when_laws_are_enforced_and_nothing_becomes_negative) {
  const FactorScene cube(cube_a(), Between::patches, ElementSides::front, 0.8f);
  const auto truth = cube.exact();
  Errors before, after;
  for (int seed = 1; seed <= seeds; ++seed) {
    auto factors = cube.counted({.seed = static_cast<std::uint64_t>(seed), .rays = 256, .error = 0.0});
    before.add(factors, truth);
    const auto done = enforce_laws(factors, cube.context);
    after.add(factors, truth);
    EXPECT_LT(done.worst_row_sum, 1e-12);
    EXPECT_LT(done.change_in_standard_errors, 1.5);
    for (std::size_t i = 0; i < factors.size(); ++i) EXPECT_NEAR(row_sum(factors, i), 1.0, 1e-12);
    for (const auto f : factors.factor) EXPECT_TRUE(f > 0.0 && f <= 1.0);
  }
  // Two estimates joined have half the variance; the row sums take off some more.
  EXPECT_LT(after.squares, 0.55 * before.squares);
}

TEST(ViewFactorErrors, of_unlike_areas_have_no_bias_when_joined) {
  // A small plate over a large one: both count the same exchange area, one much better.
  SceneBuilder b;
  b.material("large", 0.5f, 0.0f, false).quad({-4, -4, 0}, {4, -4, 0}, {4, 4, 0}, {-4, 4, 0});
  b.material("small", 0.5f, 0.0f, false)
      .quad({-0.2f, 0.2f, 1}, {0.2f, 0.2f, 1}, {0.2f, -0.2f, 1}, {-0.2f, -0.2f, 1});
  const FactorScene plates(b.scene(), Between::materials);
  const auto truth = factor(plates.exact(), "large", "small").value;
  double sum = 0.0, squares = 0.0;
  for (int seed = 1; seed <= seeds; ++seed) {
    auto factors = plates.counted({.seed = static_cast<std::uint64_t>(seed), .rays = 256, .error = 0.0});
    enforce_laws(factors, plates.context);
    const auto error = factor(factors, "large", "small").value - truth;
    sum += error;
    squares += error * error;
  }
  const auto mean = sum / seeds;
  EXPECT_LT(std::fabs(mean), 4.0 * std::sqrt((squares / seeds - mean * mean) / seeds) + 1e-9);
}

}  // namespace
}  // namespace luxel::truth
