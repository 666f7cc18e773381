// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "luxel/lighting/calculation_grid.h"
#include "luxel/lighting/isolux.h"

namespace luxel {

// The room that a drawing to scale has, pixels.
struct DrawingSize {
  double width = 720.0, max_height = 860.0;
  double head = 0.0;    // above the drawing
  double around = 0.1;  // m of the plan that is shown around the grid, beside 6 % of the grid's size
};

// The place of a grid and of the plan around it in a drawing.
class PlanView {
 public:
  PlanView() = default;
  // Shows the cells that have points, and what of the plan lies close around them. plan: lines, m in the
  // grid's plane.
  PlanView(const CalculationGrid& grid, const std::vector<std::vector<Vec2d>>& plan, const DrawingSize& size);

  double scale() const { return scale_; }    // pixels per m
  double height() const { return height_; }  // pixels, of what is drawn to scale
  Vec2d at(const Vec2d& p) const {
    return {left_ + scale_ * (p.x - low_.x), head_ + scale_ * (high_.y - p.y)};
  }
  // "M1.0 2.0L..." of points in the plane.
  std::string path(const std::vector<Vec2d>& points, bool is_closed) const;
  // The opening tags of an <svg> and a <g> that cut what lies outside.
  std::string begin() const;
  double length_of(const IsoluxLine& line) const;  // pixels

 private:
  Vec2d low_{0.0}, high_{0.0};  // m
  double scale_ = 1.0, left_ = 0.0, head_ = 0.0, height_ = 0.0;
};

using TextBox = std::array<double, 4>;  // pixels: low and high corners

// Labels of lines by level.
struct LabelStyle {
  std::function<std::string(double level)> text, colour;
};

// One label per line that is long enough, where no other text is; else none. taken: boxes of texts, to which
// those of the labels are added.
std::string isolux_labels(std::vector<IsoluxLine> lines, const PlanView& view, const LabelStyle& style,
                          std::vector<TextBox>& taken);

}  // namespace luxel
