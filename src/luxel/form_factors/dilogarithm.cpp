// SPDX-License-Identifier: Apache-2.0
#include "luxel/form_factors/dilogarithm.h"

#include <array>

#include "luxel/core/logarithm.h"
#include "luxel/core/trig.h"

namespace luxel {
namespace {

// Complex numbers without std::complex's handling of infinities, which costs more than the product itself.
struct Complex {
  double re = 0.0, im = 0.0;
};
Complex operator*(const Complex& a, const Complex& b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}

// B_2k / (2k + 1)!, k from 1.
constexpr std::array<double, 11> bernoulli = {
    0.027777777777777776,  -0.0002777777777777778,  4.72411186696901e-06,  -9.185773074661964e-08,
    1.8978869988971e-09,   -4.0647616451442256e-11, 8.921691020456452e-13, -1.9939295860721074e-14,
    4.518980029619918e-16, -1.0356517612181247e-17, 2.395218621026187e-19};

// Im Li2(z) = Im sum of B_k w^(k+1) / (k+1)!, w = -ln(1 - z), |w| <= 1.3.
double debye(const Complex& w) {
  const auto w2 = w * w;
  Complex sum{bernoulli.back(), 0.0};
  for (auto k = bernoulli.size() - 1; k-- > 0;) {
    sum = sum * w2;
    sum.re += bernoulli[k];
  }
  return w.im - 0.25 * w2.im + (sum * (w2 * w)).im;
}

}  // namespace

double dilogarithm_imaginary(double radius, double angle, double cosine, double sine) {
  if (!(radius > 0.0)) return 0.0;
  const auto re = radius * cosine;
  const auto im = radius * sine;
  const Complex rest{1.0 - re, -im};  // 1 - z
  const auto rest2 = rest.re * rest.re + im * im;
  const Complex log_rest{rest2 > 0.0 ? 0.5 * natural_logarithm(rest2) : 0.0, arc_tangent(rest.im, rest.re)};
  if (re <= 0.5) return debye({-log_rest.re, -log_rest.im});
  // Li2(z) = pi²/6 - ln z ln(1 - z) - Li2(1 - z), where -ln(1 - (1 - z)) = -ln z.
  const Complex log_z{natural_logarithm(radius), angle};
  return -(log_z * log_rest).im - debye({-log_z.re, -log_z.im});
}

}  // namespace luxel
