// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "luxel/lighting/calculation_plane.h"

namespace luxel {

// A line of equal illuminance in the plane of a grid, m.
struct IsoluxLine {
  double level = 0.0;  // lx
  std::vector<Vec2d> points;
  bool is_closed = false;
};

// The levels of lines for values from low to high: the steps of the illuminance scale of EN 12464-1 (20, 30,
// 50, 75, 100, 150, 200 lx ...) where at least four of these lie between them; else multiples of 1, 2 or 5
// times a power of ten, five to twelve of them. Empty where low is not below high.
std::vector<double> isolux_levels(double low, double high);

// Lines of equal value of the smooth interpolant through the points of a grid (bicubic, Catmull and Rom
// 1974), by marching squares on squares of four points that are cut 8 x 8. They end at the outer points, and
// beside cells without a point. values: [point]. Between the points of a coarse grid the interpolant may
// exceed them by up to an eighth of the difference of neighbours.
std::vector<IsoluxLine> isolux_lines(const CalculationGrid& grid, const std::vector<double>& values,
                                     const std::vector<double>& levels);

}  // namespace luxel
