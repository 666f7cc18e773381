// SPDX-License-Identifier: Apache-2.0
#include "scenes/furniture/curtains.h"

#include <cmath>
#include <numbers>

#include "scenes/shapes/sheets.h"
#include "scenes/shapes/sweeping.h"
#include "scenes/shapes/turning.h"

namespace luxel::scenes {

Mesh curtain(double width, double height, int folds) {
  constexpr auto hem = 0.02;  // m above the floor
  const auto mesh = sheet(12 * folds, 6, [&](double s, double t) {
    // Folds are even where they hang from the rod, and wander and deepen on their way down.
    const auto down = 1.0 - t;
    const auto phase = 2.0 * std::numbers::pi * folds * s + 0.9 * down * std::sin(5.0 * s + 1.0);
    const auto depth = 0.028 + 0.022 * down;
    const auto x = width * (s + 0.012 * down * std::sin(9.0 * s));
    return Vec3d(x, hem + t * (height - hem), depth * std::sin(phase));
  });
  return painted(mesh, Paint::curtain_rose);
}

Mesh curtain_rod(double length) {
  const auto half = 0.5 * length;
  const auto rod = tube({{-half, 0.0, 0.0}, {half, 0.0, 0.0}}, 0.012, 16);
  const auto ball = sphere(0.026, 12);
  return painted(joined({rod, moved(ball, {-half - 0.027, 0.0, 0.0}), moved(ball, {half + 0.027, 0.0, 0.0})}),
                 Paint::brass);
}

}  // namespace luxel::scenes
