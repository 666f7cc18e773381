// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "luxel/export/plan_axes.h"

namespace luxel {

// The scale of a plan drawing, and texts of SVG elements. Units of the drawing: 680 are the width of a page.
class SvgSheet {
 public:
  static constexpr double text_size = 13.0;  // of labels

  // low, high: corners of what is drawn, m; it fills a page's width or 300 units of height. below: units that
  // are left free below the drawing.
  SvgSheet(const PlanPoint& low, const PlanPoint& high, double below);

  double scale() const { return scale_; }  // units per metre
  PlanPoint at(const PlanPoint& place) const;
  double bottom() const { return bottom_; }  // of the drawing, units
  double left() const { return margin; }
  double right() const { return right_; }

  // "M1.0 2.0L...Z" of a closed loop in metres.
  std::string path_of(std::span<const PlanPoint> loop) const;
  // The opening tag with its title, which is for readers that do not see it; title without markup.
  std::string begin(const std::string& title) const;

 private:
  static constexpr double margin = 34.0;
  PlanPoint low_;
  double scale_, bottom_, right_, below_;
};

// One text, centred at a point of the sheet; text without markup. attributes: further ones, may be empty.
std::string svg_text(const PlanPoint& at, const std::string& text, double size,
                     const std::string& attributes = {});
// A line between points of the sheet.
std::string svg_line(const PlanPoint& from, const PlanPoint& to, const std::string& attributes);

}  // namespace luxel
