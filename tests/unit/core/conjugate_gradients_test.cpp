// SPDX-License-Identifier: Apache-2.0
#include "luxel/core/conjugate_gradients.h"

#include <cstddef>

#include <gtest/gtest.h>

namespace luxel {
namespace {

using Vector = std::vector<double>;

// -u'' on a line of n points, whose ends are 0; plus i in row i.
void multiply(const Vector& v, Vector& result) {
  for (std::size_t i = 0; i < v.size(); ++i)
    result[i] = (2.0 + static_cast<double>(i)) * v[i] - (i > 0 ? v[i - 1] : 0.0) -
                (i + 1 < v.size() ? v[i + 1] : 0.0);
}

void divide_by_diagonal(const Vector& r, Vector& result) {
  for (std::size_t i = 0; i < r.size(); ++i) result[i] = r[i] / (2.0 + static_cast<double>(i));
}

double dot(const Vector& a, const Vector& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

const LinearSystem system{multiply, divide_by_diagonal, dot};
const auto always = [](int, const Vector&) { return true; };

TEST(ConjugateGradients, solve_a_system_in_at_most_as_many_steps_as_unknowns) {
  constexpr std::size_t n = 20;
  Vector wanted(n), right(n), x(n, 0.0);
  for (std::size_t i = 0; i < n; ++i) wanted[i] = i % 3 == 0 ? 1.0 : -0.5;
  multiply(wanted, right);
  const auto steps = conjugate_gradients(x, right, {100, 1e-26}, system, always);
  EXPECT_GT(steps, 3);
  EXPECT_LE(steps, 20);
  for (std::size_t i = 0; i < n; ++i) EXPECT_NEAR(x[i], wanted[i], 1e-12);
}

TEST(ConjugateGradients, stop_where_they_are_told) {
  Vector x(20, 0.0);
  EXPECT_EQ(conjugate_gradients(x, Vector(20, 1.0), {3, 0.0}, system, always), 3);
  EXPECT_EQ(conjugate_gradients(x, Vector(20, 1.0), {100, 0.0}, system,
                                [](int step, const Vector&) { return step < 2; }),
            2);
  EXPECT_EQ(conjugate_gradients(x, Vector(20, 0.0), {100, 1e-20}, system, always), 0);
  EXPECT_EQ(conjugate_gradients(x, Vector(20, 1.0), {100, 1e-3, 1e9}, system, always), 0);
}

}  // namespace
}  // namespace luxel
