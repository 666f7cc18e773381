// SPDX-License-Identifier: Apache-2.0
#include "luxel/lighting/metric_plan.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "luxel/lighting/isolux.h"
#include "luxel/lighting/plan_view.h"
#include "luxel/lighting/svg_parts.h"

namespace luxel {
namespace {

constexpr double narrow_panel = 440.0, wide_panel = 760.0;  // pixels: widths of a drawing
constexpr double panel_foot = 86.0;                         // pixels: legend, scale bar and north

class Panel {
 public:
  Panel(const MetricGround& ground, const MetricPlan& metric, const DrawingSize& size)
      : ground_(ground), metric_(metric), size_(size), view_(ground.grid, ground.plan, size) {}

  double height() const { return size_.head + view_.height() + panel_foot; }

  std::string svg() {
    text_ += chart_title_svg(metric_.title, metric_.figures, svg_margin) + view_.begin();
    lines_ = isolux_lines(ground_.grid, metric_.values, metric_.lines);
    const auto label = [&](double level) { return scale_number(level) + " " + metric_.scale.unit; };
    const auto labels =
        isolux_labels(lines_, view_, {label, [](double) { return std::string("#111"); }}, taken_);
    draw_cells();
    draw_room();
    draw_lines();
    draw_numbers();
    text_ += "</g>\n</svg>\n" + labels;
    draw_foot();
    return std::move(text_);
  }

 private:
  // Pixels.
  Vec2d cell_size() const {
    const auto& grid = ground_.grid;
    return view_.scale() * Vec2d(grid.width / static_cast<double>(grid.columns),
                                 grid.height / static_cast<double>(grid.rows));
  }

  void draw_cells() {
    const auto& grid = ground_.grid;
    const auto cell = cell_size();
    for (std::size_t i = 0; i < metric_.values.size(); ++i) {
      const auto low = view_.at(grid.middle(grid.cell[i])) - 0.5 * cell;
      text_ += fmt::format(
          "<rect class=\"cell\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"{}\" "
          "shape-rendering=\"crispEdges\"/>\n",
          low.x, low.y, cell.x + 0.3, cell.y + 0.3, metric_.scale.colour(metric_.values[i]));
    }
  }

  // In cells that are large enough, where no line and no label is.
  void draw_numbers() {
    const auto& grid = ground_.grid;
    const auto cell = cell_size();
    std::size_t letters = 1;
    for (const auto v : metric_.values) letters = std::max(letters, number(v).size());
    const auto width_of_one = svg_letter * static_cast<double>(letters);  // over the size of the text
    constexpr double filled = 0.8, max_size = 11.0, min_size = 6.5;       // part of a cell; pixels
    const auto size = std::min({max_size, filled * cell.y, filled * cell.x / width_of_one});
    if (size < min_size) return;
    const Vec2d half(0.5 * size * width_of_one, 0.5 * size);
    for (std::size_t i = 0; i < metric_.values.size(); ++i) {
      const auto v = metric_.values[i];
      const auto m = view_.at(grid.middle(grid.cell[i]));
      if (is_taken(m - half, m + half)) continue;
      text_ += fmt::format(
          "<text class=\"value\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\" font-size=\"{:.1f}\" "
          "fill=\"{}\">{}</text>\n",
          m.x, m.y + 0.35 * size, size, metric_.scale.text_colour(v), number(v));
    }
  }

  bool is_taken(const Vec2d& low, const Vec2d& high) const {
    constexpr double line_width = 3.4;  // pixels
    for (const auto& box : taken_)
      if (low.x < box[2] && high.x > box[0] && low.y < box[3] && high.y > box[1]) return true;
    for (const auto& line : lines_)
      for (const auto& point : line.points) {
        const auto p = view_.at(point);
        if (p.x > low.x - line_width && p.x < high.x + line_width && p.y > low.y - line_width &&
            p.y < high.y + line_width)
          return true;
      }
    return false;
  }

  std::string number(double value) const { return fmt::format("{:.{}f}", value, metric_.decimals); }

  void draw_room() {
    // With bright edges, so that furniture is seen on dark cells, too.
    for (const char* stroke : {"stroke=\"#fff\" stroke-width=\"4.5\" stroke-opacity=\"0.6\"",
                               "stroke=\"#222\" stroke-width=\"2\""})
      for (const auto& line : ground_.plan)
        text_ += fmt::format("<path d=\"{}\" {}/>\n", view_.path(line, false), stroke);
    for (const auto& line : ground_.openings)
      text_ += fmt::format("<path class=\"opening\" d=\"{}\" {}/>\n", view_.path(line, false), opening_line);
  }

  void draw_lines() {
    for (const char* stroke :
         {"stroke=\"#000\" stroke-width=\"3.4\"", "stroke=\"#fff\" stroke-width=\"1.6\""})
      for (const auto& line : lines_)
        text_ += fmt::format("<path class=\"line\" d=\"{}\" {}/>\n", view_.path(line.points, line.is_closed),
                             stroke);
  }

  void draw_foot() {
    const auto top = size_.head + view_.height() + 10.0;
    constexpr double for_unit = 22.0;  // pixels: the last mark is wider
    text_ += legend_svg(metric_.scale, svg_margin + 4.0, top, size_.width - 2.0 * svg_margin - for_unit);
    const auto y = top + 56.0;
    const auto length = round_length(0.25 * (size_.width - 2.0 * svg_margin) / view_.scale());
    auto x = svg_margin + view_.scale() * length;
    text_ += fmt::format("<path d=\"M{:g} {:.1f}v8h{:.1f}v-8\" fill=\"none\" stroke=\"#333\"/>\n", svg_margin,
                         y - 4.0, view_.scale() * length);
    text_ += svg_text(fmt::format("{:g} m", length), {x + 8.0, y}, "start", "#333");
    if (!ground_.openings.empty()) {
      x += 62.0;
      text_ += fmt::format("<path d=\"M{:.1f} {:.1f}h22\" fill=\"none\" {}/>\n", x, y, opening_line);
      text_ += svg_text("window or opening", {x + 30.0, y}, "start", "#333");
    }
    if (ground_.north) draw_north({size_.width - svg_margin - 14.0, y - 2.0});
  }

  // An arrow with an N at its tip.
  void draw_north(const Vec2d& at) {
    const Vec2d ahead(ground_.north->x, -ground_.north->y), aside(-ahead.y, ahead.x);
    const auto tip = at + 9.0 * ahead, tail = at - 11.0 * ahead;
    const auto left = tail + 6.0 * aside, right = tail - 6.0 * aside, inner = tail + 4.0 * ahead;
    text_ += fmt::format(
        "<path class=\"north\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}L{:.1f} {:.1f}L{:.1f} {:.1f}Z\" "
        "fill=\"#333\"/>\n",
        tip.x, tip.y, left.x, left.y, inner.x, inner.y, right.x, right.y);
    text_ += svg_text("N", at + 17.0 * ahead, "middle", "#333", "bold");
  }

  static constexpr const char* opening_line = "stroke=\"#3aa0e8\" stroke-width=\"4\" stroke-linecap=\"butt\"";

  const MetricGround& ground_;
  const MetricPlan& metric_;
  DrawingSize size_;
  PlanView view_;
  std::vector<IsoluxLine> lines_;
  std::vector<TextBox> taken_;
  std::string text_;
};

}  // namespace

CalculationGrid rectangular_grid(const Vec3d& corner, const Vec3d& first, const Vec3d& second,
                                 std::size_t columns, std::size_t rows) {
  CalculationGrid grid;
  grid.corner = corner;
  grid.width = glm::length(first - corner);
  grid.height = glm::length(second - corner);
  grid.along = (first - corner) / grid.width;
  grid.across = (second - corner) / grid.height;
  grid.normal = glm::cross(grid.along, grid.across);
  grid.columns = columns;
  grid.rows = rows;
  grid.cell.resize(columns * rows);
  std::iota(grid.cell.begin(), grid.cell.end(), 0u);
  for (const auto cell : grid.cell) {
    const auto m = grid.middle(cell);
    grid.position.push_back(corner + m.x * grid.along + m.y * grid.across);
  }
  return grid;
}

std::vector<std::vector<Vec2d>> openings_of(const CalculationGrid& grid,
                                            const std::vector<Vec3d>& triangles) {
  std::vector<std::vector<Vec2d>> lines;
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
    std::vector<Vec2d> loop;
    for (std::size_t k = 0; k < 4; ++k) {
      const auto d = triangles[i + k % 3] - grid.corner;
      loop.emplace_back(glm::dot(d, grid.along), glm::dot(d, grid.across));
    }
    lines.push_back(std::move(loop));
  }
  return lines;
}

bool is_wide_plan(const CalculationGrid& grid) { return grid.width > 2.0 * grid.height; }

namespace {

DrawingSize size_of(const MetricGround& ground, const std::vector<MetricPlan>& plans, double width) {
  std::size_t lines = 0;
  for (const auto& plan : plans) lines = std::max(lines, plan.figures.size());
  return {
      .width = width, .max_height = 1.3 * width, .head = chart_title_height(lines), .around = ground.around};
}

}  // namespace

std::string metric_plans_svg(const MetricGround& ground, const std::vector<MetricPlan>& plans) {
  const auto columns = plans.size() == 1 || is_wide_plan(ground.grid) ? std::size_t{1} : std::size_t{2};
  const auto size = size_of(ground, plans, columns == 1 ? wide_panel : narrow_panel);
  double height = 0.0;
  std::string parts;
  for (std::size_t i = 0; i < plans.size(); ++i) {
    Panel panel(ground, plans[i], size);
    height = panel.height();
    const auto x = size.width * static_cast<double>(i % columns),
               y = height * static_cast<double>(i / columns);
    parts += fmt::format("<g transform=\"translate({:.1f} {:.1f})\">\n{}</g>\n", x, y, panel.svg());
  }
  const auto rows = (plans.size() + columns - 1) / columns;
  return svg_begin(size.width * static_cast<double>(columns), height * static_cast<double>(rows)) + parts +
         "</svg>\n";
}

std::vector<std::string> metric_plan_svgs(const MetricGround& ground, const std::vector<MetricPlan>& plans) {
  const auto size = size_of(ground, plans, is_wide_plan(ground.grid) ? wide_panel : narrow_panel);
  std::vector<std::string> drawings;
  for (const auto& plan : plans) {
    Panel panel(ground, plan, size);
    drawings.push_back(svg_begin(size.width, panel.height()) + panel.svg() + "</svg>\n");
  }
  return drawings;
}

}  // namespace luxel
