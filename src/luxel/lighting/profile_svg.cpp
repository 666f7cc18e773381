// SPDX-License-Identifier: Apache-2.0
#include "luxel/lighting/profile_svg.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "luxel/lighting/svg_parts.h"

namespace luxel {
namespace {

constexpr double height = 190.0, left = 64.0, below = 22.0;  // pixels: of the axes, and beside them

class Profile {
 public:
  Profile(const PlaneResult& result, const PlaneDrawing& drawing)
      : result_(result), drawing_(drawing), head_(svg_head(result, drawing)) {
    for (const auto& light : result.light) max_ = std::max(max_, light.illuminance);
    max_ = std::max(max_, result.area.requirement.Emin.value_or(0.0));
    if (!(max_ > 0.0)) max_ = 1.0;
    step_ = round_length(0.45 * max_);
    max_ = step_ * std::ceil(1.02 * max_ / step_);
  }

  std::string svg() {
    const auto size = head_ + height + below + svg_foot;
    text_ = svg_begin(drawing_.width, size) + svg_title(result_, drawing_);
    draw_axes();
    draw_requirement();
    draw_points();
    text_ += svg_text("distance in m", {left, size - 0.5 * svg_foot}, "start", "#333");
    text_ += svg_text("illuminance in lx, " + result_.maintenance().text() +
                          (result_.area.is_direct ? ", direct light only" : ""),
                      {drawing_.width - svg_margin, size - 0.5 * svg_foot}, "end", "#333");
    return text_ + "</svg>\n";
  }

 private:
  Vec2d at(double distance, double lux) const {
    return {left + distance / result_.grid.width * (drawing_.width - left - svg_margin),
            head_ + height * (1.0 - lux / max_)};
  }

  void draw_line(const Vec2d& a, const Vec2d& b, const char* style) {
    text_ += fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" {}/>\n", a.x, a.y, b.x, b.y, style);
  }

  void draw_axes() {
    const auto end = result_.grid.width;
    for (double lux = 0.0; lux <= max_ * 1.0001; lux += step_) {
      draw_line(at(0.0, lux), at(end, lux), lux > 0.0 ? "stroke=\"#ddd\"" : "stroke=\"#555\"");
      text_ += svg_text(svg_lux(lux), at(0.0, lux) - Vec2d(6.0, 0.0), "end", "#333");
    }
    const auto step = round_length(0.25 * end);
    for (double x = 0.0; x <= end * 1.0001; x += step) {
      draw_line(at(x, 0.0), at(x, 0.0) + Vec2d(0.0, 5.0), "stroke=\"#555\"");
      text_ += svg_text(fmt::format("{:g}", x), at(x, 0.0) + Vec2d(0.0, 14.0), "middle", "#333");
    }
  }

  void draw_requirement() {
    const auto& required = result_.area.requirement.Emin;
    if (!required) return;
    draw_line(at(0.0, *required), at(result_.grid.width, *required),
              "stroke=\"#a81515\" stroke-width=\"1.5\" stroke-dasharray=\"6 4\"");
    text_ += svg_text(fmt::format("required {:g} lx", *required),
                      at(result_.grid.width, *required) - Vec2d(4.0, 9.0), "end", "#a81515");
  }

  void draw_points() {
    std::string path, points;
    for (std::size_t i = 0; i < result_.light.size(); ++i) {
      const auto p = at(result_.grid.middle(result_.grid.cell[i]).x, result_.light[i].illuminance);
      path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", p.x, p.y);
      points += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\" fill=\"#1d6996\"/>\n", p.x, p.y);
    }
    text_ +=
        fmt::format("<path class=\"profile\" d=\"{}\" fill=\"none\" stroke=\"#1d6996\"/>\n", path) + points;
  }

  const PlaneResult& result_;
  const PlaneDrawing& drawing_;
  double head_;                    // pixels
  double max_ = 0.0, step_ = 1.0;  // lx: end of the axis, distance of its marks
  std::string text_;
};

}  // namespace

std::string profile_svg(const PlaneResult& result, const PlaneDrawing& drawing) {
  return Profile(result, drawing).svg();
}

}  // namespace luxel
