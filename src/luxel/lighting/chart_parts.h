// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace luxel {

// Maps numbers to colours, from black for low to pale yellow for high, in perceptually even steps.
struct ColourScale {
  double low = 0.0, high = 100.0;  // numbers beyond have the colours of the ends
  bool is_logarithmic = false;     // needs low > 0
  std::vector<double> marks = {};  // numbers in the legend, ascending
  std::string unit = {};

  // [0, 1]
  double fraction(double number) const;
  // "#rrggbb"
  std::string colour(double number) const;
  // Black or white, whichever is readable on the colour.
  const char* text_colour(double number) const;
};

// "0.5", "250", "10,000": of a legend or a label.
std::string scale_number(double number);

// The legend as a horizontal bar with the marks below it: SVG elements. x, y: upper left corner, pixels;
// 28 pixels high.
std::string legend_svg(const ColourScale& scale, double x, double y, double width);

// Title and lines of figures at the top of a drawing: SVG elements; and their height, pixels.
std::string chart_title_svg(const std::string& title, const std::vector<std::string>& figures, double x);
double chart_title_height(std::size_t figures);

}  // namespace luxel
