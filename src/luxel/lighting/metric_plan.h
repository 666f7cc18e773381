// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "luxel/lighting/calculation_grid.h"
#include "luxel/lighting/chart_parts.h"

namespace luxel {

// Common contents of all plans of a room.
struct MetricGround {
  CalculationGrid grid;
  std::vector<std::vector<Vec2d>> plan;      // surfaces that the plan cuts, m in the grid's plane
  std::vector<std::vector<Vec2d>> openings;  // windows and other openings, seen from above; the same
  std::optional<Vec2d> north;                // unit, in the grid's plane; none where that is not level
  double around = 0.75;                      // m of the plan that is shown around the grid
};

// A metric at the points of a grid, to be drawn over the plan.
struct MetricPlan {
  std::string title;
  std::vector<std::string> figures;  // lines below the title
  std::vector<double> values;        // [point]
  ColourScale scale;
  std::vector<double> lines;  // numbers whose lines are drawn, in the unit of the scale
  int decimals = 0;           // of the numbers in the cells
};

// Axes and cells of a grid from its corner, the neighbours of the corner, m, and the numbers of cells. The
// edges must be at right angles.
CalculationGrid rectangular_grid(const Vec3d& corner, const Vec3d& first, const Vec3d& second,
                                 std::size_t columns, std::size_t rows);

// Openings seen from above, in the plane of a grid: of a window in a wall a line, of a skylight its outline.
// triangles: corners, m, three per triangle.
std::vector<std::vector<Vec2d>> openings_of(const CalculationGrid& grid, const std::vector<Vec3d>& triangles);

// Returns whether drawings of the grid take a whole row each; else two stand beside each other.
bool is_wide_plan(const CalculationGrid& grid);

// Drawings over a plan, side by side where that leaves them readable: each with coloured cells, lines,
// numbers where there is room, title, figures, legend, scale bar and north. A whole <svg> element; texts are
// escaped.
std::string metric_plans_svg(const MetricGround& ground, const std::vector<MetricPlan>& plans);
// The drawings as one <svg> element each.
std::vector<std::string> metric_plan_svgs(const MetricGround& ground, const std::vector<MetricPlan>& plans);

}  // namespace luxel
