// SPDX-License-Identifier: Apache-2.0
#include "luxel/lighting/plan_view.h"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "luxel/lighting/svg_parts.h"

namespace luxel {

PlanView::PlanView(const CalculationGrid& grid, const std::vector<std::vector<Vec2d>>& plan,
                   const DrawingSize& size)
    : head_(size.head) {
  const Vec2d half(0.5 * grid.width / static_cast<double>(grid.columns),
                   0.5 * grid.height / static_cast<double>(grid.rows));
  Vec2d low(std::numeric_limits<double>::infinity()), high(-low);
  for (const auto cell : grid.cell) {
    low = glm::min(low, grid.middle(cell) - half);
    high = glm::max(high, grid.middle(cell) + half);
  }
  const Vec2d around(size.around + 0.06 * std::max(high.x - low.x, high.y - low.y));
  const auto outer_low = low - around, outer_high = high + around;
  Vec2d plan_low(std::numeric_limits<double>::infinity()), plan_high(-plan_low);
  for (const auto& line : plan)
    for (const auto& p : line) {
      plan_low = glm::min(plan_low, p);
      plan_high = glm::max(plan_high, p);
    }
  low_ = glm::min(low, glm::max(plan_low, outer_low));
  high_ = glm::max(high, glm::min(plan_high, outer_high));
  const Vec2d rim(0.02 * std::max(high_.x - low_.x, high_.y - low_.y));
  low_ -= rim;
  high_ += rim;
  scale_ =
      std::min((size.width - 2.0 * svg_margin) / (high_.x - low_.x), size.max_height / (high_.y - low_.y));
  height_ = scale_ * (high_.y - low_.y);
  left_ = 0.5 * (size.width - scale_ * (high_.x - low_.x));
}

std::string PlanView::path(const std::vector<Vec2d>& points, bool is_closed) const {
  std::string d;
  for (const auto& p : points) {
    const auto q = at(p);
    d += fmt::format("{}{:.1f} {:.1f}", d.empty() ? "M" : "L", q.x, q.y);
  }
  return d + (is_closed ? "Z" : "");
}

std::string PlanView::begin() const {
  const auto from = at({low_.x, high_.y}), to = at({high_.x, low_.y});
  return fmt::format(
             "<svg x=\"{0:.1f}\" y=\"{1:.1f}\" width=\"{2:.1f}\" height=\"{3:.1f}\" viewBox=\"{0:.1f} "
             "{1:.1f} "
             "{2:.1f} {3:.1f}\">\n",
             from.x, from.y, to.x - from.x, to.y - from.y) +
         "<g fill=\"none\" stroke-linejoin=\"round\" stroke-linecap=\"round\">\n";
}

double PlanView::length_of(const IsoluxLine& line) const {
  double length = 0.0;
  for (std::size_t i = 1; i < line.points.size(); ++i)
    length += scale_ * glm::length(line.points[i] - line.points[i - 1]);
  return length;
}

std::string isolux_labels(std::vector<IsoluxLine> lines, const PlanView& view, const LabelStyle& style,
                          std::vector<TextBox>& taken) {
  std::stable_sort(lines.begin(), lines.end(), [](const IsoluxLine& a, const IsoluxLine& b) {
    return a.points.size() > b.points.size();
  });
  std::string svg;
  for (const auto& line : lines) {
    const auto label = style.text(line.level);
    const auto w = svg_letter * svg_text_size * static_cast<double>(label.size()) + 6.0,
               h = svg_text_size + 2.0;
    if (view.length_of(line) < 2.5 * w) continue;
    for (const double part : {0.5, 0.3, 0.7, 0.4, 0.6, 0.15, 0.85, 0.22, 0.78}) {
      const auto index = static_cast<std::size_t>(part * static_cast<double>(line.points.size() - 1));
      const auto p = view.at(line.points[index]);
      const TextBox box = {p.x - 0.5 * w, p.y - 0.5 * h, p.x + 0.5 * w, p.y + 0.5 * h};
      const auto meets = [&](const TextBox& other) {
        return box[0] < other[2] && box[2] > other[0] && box[1] < other[3] && box[3] > other[1];
      };
      if (std::any_of(taken.begin(), taken.end(), meets)) continue;
      taken.push_back(box);
      svg += fmt::format(
          "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" "
          "fill=\"#fff\" fill-opacity=\"0.9\"/>",
          box[0], box[1], w, h);
      svg += svg_text(label, p, "middle", style.colour(line.level));
      break;
    }
  }
  return svg;
}

}  // namespace luxel
