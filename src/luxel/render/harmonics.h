// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <numbers>
#include <span>

#include "luxel/core/vector.h"

namespace luxel {

// Real spherical harmonics Y of bands l = 0 to 2, orthonormal over the sphere, without the Condon-Shortley
// sign: all constants are positive (Ramamoorthi and Hanrahan 2001, equations 3 and 4). Coefficient
// l² + l + m is that of Y_lm: 1; y, z, x; xy, yz, 3z² - 1, xz, x² - y². Axes: those of the scene's file.
inline constexpr std::size_t max_harmonics = 9;

inline std::array<double, max_harmonics> harmonics(const Vec3d& d) {
  constexpr double c0 = 0.28209479177387814;   // sqrt(1 / (4 pi))
  constexpr double c1 = 0.48860251190291992;   // sqrt(3 / (4 pi))
  constexpr double c2 = 1.0925484305920792;    // sqrt(15 / (4 pi))
  constexpr double c20 = 0.31539156525252005;  // sqrt(5 / (16 pi))
  constexpr double c22 = 0.54627421529603959;  // sqrt(15 / (16 pi))
  return {c0,
          c1 * d.y,
          c1 * d.z,
          c1 * d.x,
          c2 * d.x * d.y,
          c2 * d.y * d.z,
          c20 * (3.0 * d.z * d.z - 1.0),
          c2 * d.x * d.z,
          c22 * (d.x * d.x - d.y * d.y)};
}

// The irradiance of a surface with the unit normal n, W/m², under radiance with these coefficients (1, 4 or
// 9 of them), W/(m² sr): their convolution with the cosine, pi, 2 pi / 3 and pi / 4 by band l.
inline double irradiance_of_harmonics(std::span<const double> coefficients, const Vec3d& n) {
  constexpr auto pi_double = std::numbers::pi;
  const auto y = harmonics(n);
  double sum = 0.0;
  for (std::size_t k = 0; k < coefficients.size(); ++k)
    sum += (k == 0 ? pi_double : k < 4 ? 2.0 * pi_double / 3.0 : pi_double / 4.0) * coefficients[k] * y[k];
  return sum;
}

}  // namespace luxel
