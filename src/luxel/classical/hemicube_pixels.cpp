// SPDX-License-Identifier: Apache-2.0
#include "luxel/classical/hemicube_pixels.h"

#include <cmath>
#include <cstddef>
#include <numbers>

#include "luxel/core/trig.h"

namespace luxel {
namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;

// Form factor to the rectangle [0, u] x [0, v] of the plane z = 1.
double top_corner(double u, double v) {
  const auto p = std::sqrt(1.0 + u * u);
  const auto q = std::sqrt(1.0 + v * v);
  return (u / p * arc_tangent(v, p) + v / q * arc_tangent(u, q)) / two_pi;
}

// Form factor to the rectangle [0, u] x [0, height] of the plane x = 1.
double side_corner(double u, double height) {
  const auto q = std::sqrt(1.0 + height * height);
  return (arc_tangent(u, 1.0) - arc_tangent(u, q) / q) / two_pi;
}

template <typename Corner>
double over_pixel(const Corner& corner, double u, double v, double step) {
  return (corner(u + step, v + step) - corner(u, v + step)) - (corner(u + step, v) - corner(u, v));
}

}  // namespace

HemicubePixels make_hemicube_pixels(int resolution) {
  const auto n = static_cast<std::size_t>(resolution);
  const auto half = n / 2;
  const auto step = 2.0 / resolution;
  HemicubePixels pixels{resolution, std::vector<double>(n * n), std::vector<double>(n * half)};
  for (std::size_t j = 0; j < half; ++j)
    for (std::size_t i = 0; i < half; ++i) {
      const auto u = static_cast<double>(i) * step;
      const auto v = static_cast<double>(j) * step;
      const auto above = over_pixel(top_corner, u, v, step);
      const auto aside = over_pixel(side_corner, u, v, step);
      for (const auto column : {half + i, half - 1 - i}) {
        for (const auto row : {half + j, half - 1 - j}) pixels.top[row * n + column] = above;
        pixels.side[j * n + column] = aside;
      }
    }
  return pixels;
}

}  // namespace luxel
