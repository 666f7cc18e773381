// SPDX-License-Identifier: Apache-2.0
#include "luxel/core/student_quantile.h"

#include <cassert>
#include <cmath>
#include <numbers>

namespace luxel {
namespace {

constexpr double normal_from =
    1000.0;  // degrees of freedom; t is then larger by less than 1 % in a tail of 1e-9

// Integral of cos^(v - 1) from an angle to pi / 2, by Simpson's rule in the root of the distance to pi / 2,
// so that far tails and few degrees of freedom are resolved.
double integral_from(double angle, double v) {
  constexpr int steps = 400;
  const auto length = std::sqrt(0.5 * std::numbers::pi - angle);
  double sum = 0.0;
  for (int i = 0; i <= steps; ++i) {
    const auto root = length * i / steps;
    const auto value =
        2.0 * root * std::pow(std::sin(root * root), v - 1.0);  // sin of the distance to pi / 2
    sum += (i == 0 || i == steps ? 1.0 : i % 2 == 1 ? 4.0 : 2.0) * value;
  }
  return sum * length / (3.0 * steps);
}

}  // namespace

double student_quantile(double tail, double degrees_of_freedom) {
  assert(tail > 0.0 && tail <= 0.5);
  const auto v = degrees_of_freedom;
  const bool is_normal = !(v > 0.0) || v > normal_from;
  const auto whole = is_normal ? 1.0 : 2.0 * integral_from(0.0, v);
  // The probability beyond t.
  const auto beyond = [&](double t) {
    return is_normal ? 0.5 * std::erfc(t / std::numbers::sqrt2)
                     : integral_from(std::atan(t / std::sqrt(v)), v) / whole;
  };
  double low = 0.0, high = 1.0;
  while (beyond(high) > tail && high < 1e12) high *= 2.0;
  for (int i = 0; i < 60; ++i) {
    const auto middle = 0.5 * (low + high);
    (beyond(middle) > tail ? low : high) = middle;
  }
  return high;
}

}  // namespace luxel
