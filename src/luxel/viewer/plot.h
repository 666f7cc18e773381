// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace luxel {

// A small chart in the panel that is being declared. Points ascend in x.
struct PlotPoint {
  double x = 0.0, y = 0.0;
  double error = 0.0;   // half of the band around it; 0: none
  bool is_gap = false;  // the line is broken here
};
struct PlotStyle {
  float width = 18.0f, height = 6.0f;  // heights of the text
  bool logarithmic = false;            // both axes; points that are not above 0 are left out
  double line = 0.0;                   // a level to be marked; 0: none
  const char *x_unit = "", *y_unit = "";
  bool percent = false;  // y in per cent of 1
};
void plot(const std::vector<PlotPoint>& points, const PlotStyle& style);

}  // namespace luxel
