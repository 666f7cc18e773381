// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <numbers>

namespace luxel {

// Sines and angles from + - * / sqrt alone, which every host rounds alike; the library's own differ in the
// last bits from host to host. Range reduction and a polynomial, in double; a few nanoseconds each.

struct SinCos {
  double sine = 0.0;
  double cosine = 1.0;
};

// |x| up to 1e6 rad. Error at most 1e-13, and 1e-10 at the end of the range.
inline SinCos sin_cos(double x) {
  // pi/2 in two parts: the first has 27 bits, so that its product with the quarter turns is exact.
  constexpr double half_pi_high = 0x1.921fb54000000p+0;
  constexpr double half_pi_low = 0x1.10b4611a62633p-30;
  const double quarter = std::floor(x * (2.0 / std::numbers::pi) + 0.5);
  const double r = (x - quarter * half_pi_high) - quarter * half_pi_low;
  const double r2 = r * r;
  // Taylor series to the 13th and 14th power; |r| <= pi/4.
  const double s =
      r + r * r2 *
              (-1.0 / 6.0 +
               r2 * (1.0 / 120.0 + r2 * (-1.0 / 5040.0 + r2 * (1.0 / 362880.0 + r2 * (-1.0 / 39916800.0 +
                                                                                      r2 / 6227020800.0)))));
  const double c =
      1.0 +
      r2 * (-0.5 + r2 * (1.0 / 24.0 +
                         r2 * (-1.0 / 720.0 +
                               r2 * (1.0 / 40320.0 + r2 * (-1.0 / 3628800.0 +
                                                           r2 * (1.0 / 479001600.0 - r2 / 87178291200.0))))));
  const double turn = quarter - 4.0 * std::floor(0.25 * quarter);  // 0, 1, 2 or 3
  const bool odd = turn == 1.0 || turn == 3.0;
  const double sine = odd ? c : s;
  const double cosine = odd ? s : c;
  return {turn >= 2.0 ? -sine : sine, turn == 1.0 || turn == 2.0 ? -cosine : cosine};
}

// The angle of the point (x, y) in [-pi, pi] as of the library's atan2, but 0 at the origin. Relative error
// at most 4e-15.
inline double arc_tangent(double y, double x) {
  const double ax = std::fabs(x);
  const double ay = std::fabs(y);
  const double big = ax > ay ? ax : ay;
  const double small = ax > ay ? ay : ax;
  // The octant [0, pi/4] halved: atan(t) = pi/4 + atan((t - 1) / (t + 1)); then |t| <= tan(pi/8).
  const bool upper = small > 0.41421356237309503 * big;
  const double t = upper ? (small - big) / (small + big) : (big > 0.0 ? small / big : 0.0);
  const double z = t * t;
  // Interpolates atan(t) / t in z at the Chebyshev nodes of [0, tan²(pi/8)].
  const double p =
      0.999999999999999 +
      z * (-0.3333333333322143 +
           z * (0.19999999978392663 +
                z * (-0.14285712661684793 +
                     z * (0.11111048853751296 +
                          z * (-0.09089529956562307 +
                               z * (0.07673535428183285 +
                                    z * (-0.0650598296717084 +
                                         z * (0.05024762118940128 - z * 0.025316479573776474))))))));
  double angle = (upper ? std::numbers::pi / 4.0 : 0.0) + t * p;
  if (ay > ax) angle = std::numbers::pi / 2.0 - angle;
  if (x < 0.0) angle = std::numbers::pi - angle;
  return y < 0.0 ? -angle : angle;
}

// The angle in [0, pi] of this cosine; x is clamped to [-1, 1]. Relative error at most 4e-15.
inline double arc_cosine(double x) {
  const double c = x > 1.0 ? 1.0 : (x < -1.0 ? -1.0 : x);
  return arc_tangent(std::sqrt((1.0 - c) * (1.0 + c)), c);
}

// Rounded to float, which hides the last bit of a double cosine: that one differs between hosts.
inline float cosine_of_degrees(float degrees) {
  return static_cast<float>(std::cos(static_cast<double>(degrees) * std::numbers::pi / 180.0));
}

}  // namespace luxel
