// SPDX-License-Identifier: Apache-2.0
#include "luxel/lighting/plane_svg.h"

#include <algorithm>

#include <fmt/format.h>

#include "luxel/lighting/isolux.h"
#include "luxel/lighting/plan_view.h"
#include "luxel/lighting/profile_svg.h"
#include "luxel/lighting/svg_parts.h"

namespace luxel {
namespace {

constexpr double margin = svg_margin, text_size = svg_text_size, letter = svg_letter;

class Drawing {
 public:
  Drawing(const PlaneResult& result, const PlaneDrawing& drawing) : result_(result), drawing_(drawing) {
    for (const auto& light : result.light) values_.push_back(light.illuminance);
    const auto [low, high] = std::minmax_element(values_.begin(), values_.end());
    low_value_ = *low;
    high_value_ = *high;
    choose_view();
  }

  std::string svg(bool has_lines, bool has_values) {
    begin();
    if (!has_lines) draw_cells();
    draw_plan();
    draw_outline();
    if (has_lines) draw_lines();
    if (has_values) draw_values(has_lines);
    text_ += "</g>\n</svg>\n";
    if (has_lines) draw_labels();
    draw_head_and_foot();
    return text_ + "</svg>\n";
  }

 private:
  void choose_view() {
    const auto head = svg_head(result_, drawing_);
    view_ = PlanView(result_.grid, drawing_.plan,
                     {.width = drawing_.width, .max_height = drawing_.max_height, .head = head});
    size_ = {drawing_.width, head + svg_foot + view_.height()};
  }

  double fraction(double value) const {
    return high_value_ > low_value_ ? (value - low_value_) / (high_value_ - low_value_) : 0.5;
  }

  void begin() { text_ += svg_begin(size_.x, size_.y) + view_.begin(); }

  void draw_plan() {
    for (const auto& line : drawing_.plan)
      text_ += fmt::format("<path d=\"{}\" stroke=\"#555\" stroke-width=\"2\"/>\n", view_.path(line, false));
  }
  void draw_outline() {
    for (const auto& loop : result_.grid.outline)
      text_ +=
          fmt::format("<path d=\"{}\" stroke=\"#999\" stroke-dasharray=\"5 4\"/>\n", view_.path(loop, true));
  }

  void draw_cells() {
    const auto& grid = result_.grid;
    if (!(grid.height > 0.0)) return;
    const auto w = view_.scale() * grid.width / static_cast<double>(grid.columns),
               h = view_.scale() * grid.height / static_cast<double>(grid.rows);
    for (std::size_t i = 0; i < values_.size(); ++i) {
      const auto m = view_.at(grid.middle(grid.cell[i]));
      text_ += fmt::format(
          "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"{}\" "
          "fill-opacity=\"0.22\"/>\n",
          m.x - 0.5 * w, m.y - 0.5 * h, w, h, svg_colour(fraction(values_[i])));
    }
  }

  void draw_lines() {
    const bool is_finer = !drawing_.finer_values.empty();
    lines_ = isolux_lines(is_finer ? drawing_.finer_grid : result_.grid,
                          is_finer ? drawing_.finer_values : values_, isolux_levels(low_value_, high_value_));
    for (const auto& line : lines_)
      text_ += fmt::format("<path class=\"isolux\" d=\"{}\" stroke=\"{}\" stroke-width=\"1.6\"/>\n",
                           view_.path(line.points, line.is_closed), svg_colour(fraction(line.level)));
  }

  void draw_labels() {
    text_ += isolux_labels(lines_, view_,
                           {svg_lux, [&](double level) { return svg_colour(fraction(level)); }}, taken_);
  }

  // The size of numbers on every step-th point, pixels: they leave room between them.
  double size_of_values(std::size_t letters, std::size_t step, bool has_lines) const {
    const auto& grid = result_.grid;
    const auto w = view_.scale() * grid.width / static_cast<double>(grid.columns) * static_cast<double>(step);
    const auto h = grid.height > 0.0 ? view_.scale() * grid.height / static_cast<double>(grid.rows) *
                                           static_cast<double>(step)
                                     : text_size / 0.85;
    constexpr double filled = 0.74;  // part of a cell's width; some fonts are wider than others
    return std::min({has_lines ? 0.75 * text_size : text_size, 0.85 * h,
                     filled * w / (letter * static_cast<double>(letters))});
  }

  void draw_values(bool has_lines) {
    constexpr double min_size = 7.0;  // pixels; smaller numbers cannot be read on paper
    const auto& grid = result_.grid;
    std::size_t letters = 1, step = 1;
    for (const auto v : values_) letters = std::max(letters, svg_lux(v).size());
    const auto most = std::max(grid.columns, grid.rows);
    while (step < most && size_of_values(letters, step, has_lines) < min_size) ++step;
    const auto size = size_of_values(letters, step, has_lines);
    step_ = step;
    for (std::size_t i = 0; i < values_.size(); ++i) {
      if (grid.cell[i] % grid.columns % step != 0 || grid.cell[i] / grid.columns % step != 0) continue;
      const auto p = view_.at(grid.middle(grid.cell[i]));
      const auto half = 0.5 * letter * size * static_cast<double>(svg_lux(values_[i]).size());
      taken_.push_back({p.x - half, p.y - 0.5 * size, p.x + half, p.y + 0.5 * size});
      text_ += fmt::format(
          "<text class=\"value\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\" font-size=\"{:.1f}\" "
          "fill=\"{}\" stroke=\"#fff\" stroke-width=\"2.5\" stroke-opacity=\"0.7\" "
          "paint-order=\"stroke\">{}</text>\n",
          p.x, p.y + 0.35 * size, size, has_lines ? "#777" : "#222", svg_lux(values_[i]));
    }
  }

  void write(const std::string& text, const Vec2d& p, const char* anchor, const std::string& fill) {
    text_ += svg_text(text, p, anchor, fill);
  }

  void draw_head_and_foot() {
    text_ += svg_title(result_, drawing_);
    const auto length = round_length(0.25 * (size_.x - 2.0 * margin) / view_.scale());
    const auto y = size_.y - 0.5 * svg_foot, x = margin, end = margin + view_.scale() * length;
    text_ += fmt::format("<path d=\"M{:.1f} {:.1f}v8h{:.1f}v-8\" fill=\"none\" stroke=\"#333\"/>\n", x,
                         y - 4.0, end - x);
    write(fmt::format("{:g} m", length), {end + 8.0, y}, "start", "#333");
    const auto note = step_ > 1 ? fmt::format("every {}. point; ", step_) : std::string();
    write(note + "illuminance in lx, " + result_.maintenance().text(), {size_.x - margin, y}, "end", "#333");
  }

  const PlaneResult& result_;
  const PlaneDrawing& drawing_;
  std::vector<double> values_;
  std::vector<IsoluxLine> lines_;
  std::vector<TextBox> taken_;
  double low_value_ = 0.0, high_value_ = 0.0;  // lx
  PlanView view_;
  Vec2d size_{0.0};       // pixels
  std::size_t step_ = 1;  // values stand at every step-th column and row
  std::string text_;
};

}  // namespace

std::string isolux_svg(const PlaneResult& result, const PlaneDrawing& drawing) {
  if (!(result.grid.height > 0.0)) return profile_svg(result, drawing);
  return Drawing(result, drawing).svg(true, drawing.has_values);
}

bool has_isolux_lines(const PlaneResult& result, const PlaneDrawing& drawing) {
  const auto& grid = drawing.finer_values.empty() ? result.grid : drawing.finer_grid;
  if (!(result.grid.height > 0.0)) return true;
  const auto point = grid.point_of_cells();
  for (std::size_t j = 0; j + 1 < grid.rows; ++j)
    for (std::size_t i = 0; i + 1 < grid.columns; ++i) {
      const auto first = j * grid.columns + i;
      if (point[first] != none && point[first + 1] != none && point[first + grid.columns] != none &&
          point[first + grid.columns + 1] != none)
        return true;
    }
  return false;
}

std::string value_grid_svg(const PlaneResult& result, const PlaneDrawing& drawing) {
  return Drawing(result, drawing).svg(false, true);
}

}  // namespace luxel
