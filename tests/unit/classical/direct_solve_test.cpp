// SPDX-License-Identifier: Apache-2.0
#include "luxel/classical/direct_solve.h"

#include <cmath>

#include <gtest/gtest.h>

#include "luxel/core/error.h"

#include "support/random_matrix.h"

namespace luxel {
namespace {

std::vector<float> solved(const test::RandomMatrix& matrix, int threads = 0) {
  std::vector<float> radiosity(matrix.emittance.size());
  const Context context(threads);
  EXPECT_TRUE(solve_directly(matrix.factors, matrix.emittance, matrix.reflectance, radiosity, context));
  return radiosity;
}

// Residual of B = E + rho F B, relative to B.
double worst_residual(const test::RandomMatrix& matrix, const std::vector<float>& radiosity) {
  std::vector<float> gathered(radiosity.size());
  const Context context;
  matrix.apply(radiosity, gathered, 0, matrix.size(), context);
  double worst = 0.0;
  for (std::size_t i = 0; i < radiosity.size(); ++i) {
    const auto B = matrix.emittance[i] + matrix.reflectance[i] * gathered[i];
    worst = std::max(worst, static_cast<double>(std::abs(B / radiosity[i] - 1.0f)));
  }
  return worst;
}

TEST(DirectSolve, solves_systems_of_any_size) {
  for (const std::size_t rows : {6u, 47u, 48u, 49u, 96u, 203u}) {
    const test::RandomMatrix matrix(rows);
    EXPECT_LT(worst_residual(matrix, solved(matrix)), 3e-7) << rows << " rows";
  }
}

TEST(DirectSolve, bands_that_reflect_alike_get_the_answer_they_get_apart) {
  test::RandomMatrix matrix(60);
  for (std::size_t i = 0; i < matrix.reflectance.size(); i += 2)
    matrix.reflectance[i + 1] = matrix.reflectance[i];
  EXPECT_LT(worst_residual(matrix, solved(matrix)), 3e-7);
}

TEST(DirectSolve, picks_pivots) {
  // No light transport, but a system without a first pivot: x1 = 2, x0 = 3.
  const std::vector<float> factors = {1.0f, -1.0f, -1.0f, 1.0f};  // I - F = [0 1; 1 0]
  const std::vector<float> right = {2.0f, 3.0f}, one = {1.0f, 1.0f};
  std::vector<float> x(2);
  ASSERT_TRUE(solve_directly(factors, right, one, x, Context(1)));
  EXPECT_EQ(x, (std::vector<float>{3.0f, 2.0f}));
}

TEST(DirectSolve, refuses_what_has_no_single_answer) {
  const std::vector<float> factors = {0.0f, 1.0f, 1.0f, 0.0f};  // two white plates that face each other alone
  const std::vector<float> right = {1.0f, 0.0f}, one = {1.0f, 1.0f};
  std::vector<float> x(2);
  EXPECT_THROW(solve_directly(factors, right, one, x, Context(1)), InputError);
}

TEST(DirectSolve, is_the_same_on_any_number_of_threads) {
  const test::RandomMatrix matrix(203);
  EXPECT_EQ(solved(matrix, 1), solved(matrix, 5));
}

TEST(DirectSolve, that_is_stopped_leaves_the_lamps) {
  const test::RandomMatrix matrix(60);
  std::vector<float> radiosity(matrix.emittance.size());
  EXPECT_FALSE(solve_directly(matrix.factors, matrix.emittance, matrix.reflectance, radiosity,
                              Context(1).with_monitor([](const Progress&) { return Next::stop; })));
  EXPECT_EQ(radiosity, matrix.emittance);
}

}  // namespace
}  // namespace luxel
