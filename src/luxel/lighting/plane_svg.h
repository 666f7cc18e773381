// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "luxel/lighting/calculation_plane.h"

namespace luxel {

struct PlaneDrawing {
  std::vector<std::vector<Vec2d>> plan;  // what the plane cuts, see plan_of(); m
  double width = 720.0;                  // pixels of the picture
  double max_height = 860.0;             // pixels of what is drawn to scale, without head and foot
  bool has_values = false;               // values at the grid's points, beside the lines
  std::string title;                     // empty: the name of the area, with mean and uniformity
  // Points of a finer grid over the same area, from which lines are drawn; empty: from the result's own.
  CalculationGrid finer_grid = {};
  std::vector<double> finer_values = {};  // lx
};

// The lines of equal illuminance of an area over its plan, with labels, a scale bar and the outline of the
// area: a whole <svg> element with sizes and colours of its own, which may stand in a file or in an HTML
// page. The text is escaped. Drawn from values, not from their intervals. A line, such as that of an escape
// route, has its profile instead: illuminance over distance, with the required minimum.
std::string isolux_svg(const PlaneResult& result, const PlaneDrawing& drawing = {});

// Returns whether isolux_svg() of this result shows anything but the plan: a line, or a square of four
// points.
bool has_isolux_lines(const PlaneResult& result, const PlaneDrawing& drawing = {});

// The same with the value at each point in lx, each cell tinted by its value, without lines. Where the
// numbers would be too small to read, those of every second or third point.
std::string value_grid_svg(const PlaneResult& result, const PlaneDrawing& drawing = {});

}  // namespace luxel
