// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/unfolded_room.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "luxel/export/floor_outline.h"
#include "luxel/export/number_text.h"
#include "luxel/lighting/isolux.h"
#include "luxel/lighting/svg_parts.h"

namespace luxel {
namespace {

constexpr double in_front = 0.01;     // m: of the points, before the surface
constexpr double min_covered = 0.5;   // fraction of a face that surfaces cover, at least
constexpr double right_angle = 1e-3;  // cosine of the angle between neighbouring edges, at most

bool is_rectangle(const RoomData& room) {
  if (room.outline.size() != 1 || room.outline[0].size() != 4) return false;
  const auto& c = room.outline[0];
  for (std::size_t i = 0; i < 4; ++i) {
    const auto a = glm::normalize(c[(i + 1) % 4] - c[i]), b = glm::normalize(c[(i + 2) % 4] - c[(i + 1) % 4]);
    if (std::abs(glm::dot(a, b)) > right_angle) return false;
  }
  return true;
}

double summed_area(const PatchSet& patches, const std::vector<std::uint32_t>& which) {
  double sum = 0.0;
  for (const auto p : which) sum += static_cast<double>(patches.area[p]);
  return sum;
}

// The corners of an edge of the outline.
struct RoomEdge {
  PlanPoint from, to;
  PlanPoint outwards() const {
    const auto along = glm::normalize(to - from);
    return {along.y, -along.x};  // the outline runs anticlockwise
  }
};

RoomEdge edge_of(const RoomData& room, std::size_t i) {
  return {room.outline[0][i], room.outline[0][(i + 1) % 4]};
}

std::vector<std::uint32_t> patches_of(const RoomData& room, const PatchSet& patches, const RoomEdge& edge) {
  constexpr double near = 0.02;  // m
  std::vector<std::uint32_t> found;
  for (const auto p : room.walls) {
    const auto at = room.axes.in_plan(patches.in_file(patches.centroid(p)));
    if (std::abs(glm::dot(PlanPoint(at.x, at.y) - edge.from, edge.outwards())) < near) found.push_back(p);
  }
  return found;
}

CalculationArea level_area(const RoomData& room, double height, bool faces_up) {
  CalculationArea area;
  for (const auto& c : room.outline[0]) area.polygon.push_back(room.axes.in_scene({c.x, c.y, height}));
  area.normal = faces_up ? room.axes.up : -room.axes.up;
  return area;
}

CalculationArea upright_area(const RoomData& room, const RoomEdge& edge) {
  const auto inwards = -edge.outwards();
  const auto from = edge.from + in_front * inwards, to = edge.to + in_front * inwards;
  CalculationArea area;
  for (const auto& [foot, height] :
       {std::pair{from, room.low.z}, {to, room.low.z}, {to, room.high.z}, {from, room.high.z}})
    area.polygon.push_back(room.axes.in_scene({foot.x, foot.y, height}));
  area.normal = room.axes.in_scene({inwards.x, inwards.y, 0.0});
  return area;
}

// Place of a point of a face on the sheet, m: the floor as on the plan, its lowest edge to the right.
class UnfoldedSheet {
 public:
  explicit UnfoldedSheet(const RoomData& room) : room_(room), height_(room.high.z - room.low.z) {
    for (std::size_t i = 1; i < 4; ++i)
      if (edge_of(room, i).outwards().y < edge_of(room, first_).outwards().y) first_ = i;
    const auto corner = [&](std::size_t i) { return room.outline[0][(first_ + i) % 4]; };
    origin_ = corner(0);
    right_ = glm::normalize(corner(1) - origin_);
    ahead_ = glm::normalize(corner(3) - origin_);
    size_ = {glm::length(corner(1) - origin_), glm::length(corner(3) - origin_)};
  }
  Vec2d low() const { return {-height_, -height_}; }
  Vec2d high(bool has_ceiling) const {
    return {size_.x + height_, size_.y + height_ + (has_ceiling ? size_.y : 0.0)};
  }
  Vec2d at(const RoomFace& face, const Vec3d& point) const {
    const auto plan = room_.axes.in_plan(point);
    const auto from = PlanPoint(plan.x, plan.y) - origin_;
    const Vec2d place(glm::dot(from, right_), glm::dot(from, ahead_));
    if (face.kind == RoomFaceKind::floor) return place;
    if (face.kind == RoomFaceKind::ceiling) return {place.x, 2.0 * size_.y + height_ - place.y};
    const auto above = plan.z - room_.low.z;
    switch ((face.edge + 4 - first_) % 4) {
      case 0:
        return {place.x, -above};
      case 1:
        return {size_.x + above, place.y};
      case 2:
        return {place.x, size_.y + above};
      default:
        return {-above, place.y};
    }
  }

 private:
  const RoomData& room_;
  double height_;          // m
  std::size_t first_ = 0;  // the edge that lies lowest on the plan
  PlanPoint origin_{0.0}, right_{0.0}, ahead_{0.0}, size_{0.0};
};

class Unfolded {
 public:
  Unfolded(const UnfoldedRoom& faces, const RoomData& room) : faces_(faces), sheet_(room) {
    bool has_ceiling = false;
    for (const auto& [face, result] : faces) {
      has_ceiling = has_ceiling || face.kind == RoomFaceKind::ceiling;
      for (const auto& light : result.light) {
        low_value_ = std::min(low_value_, light.illuminance);
        high_value_ = std::max(high_value_, light.illuminance);
      }
    }
    low_ = sheet_.low();
    const auto size = sheet_.high(has_ceiling) - low_;
    scale_ = std::min((width - 2.0 * svg_margin) / size.x, max_height / size.y);
    left_ = 0.5 * (width - scale_ * size.x);
    bottom_ = top + scale_ * size.y;
  }

  std::string svg() {
    text_ = svg_begin(width, bottom_ + foot);
    text_ += "<g shape-rendering=\"crispEdges\">\n";
    for (const auto& measured : faces_) draw_cells(measured);
    text_ += "</g>\n";
    for (const auto& measured : faces_) draw_lines(measured);
    for (const auto& measured : faces_) draw_outline_and_name(measured);
    draw_labels();
    draw_legend();
    return text_ + "</svg>\n";
  }

 private:
  static constexpr double width = 720.0, max_height = 400.0, top = 8.0, foot = 56.0;  // pixels

  Vec2d at(const RoomFace& face, const Vec3d& point) const {
    const auto p = sheet_.at(face, point) - low_;
    return {left_ + scale_ * p.x, bottom_ - scale_ * p.y};
  }
  Vec2d at(const MeasuredFace& m, const Vec2d& p) const {
    const auto& grid = m.result.grid;
    return at(m.face, grid.corner + p.x * grid.along + p.y * grid.across);
  }
  double fraction(double lux) const {
    return high_value_ > low_value_ ? (lux - low_value_) / (high_value_ - low_value_) : 0.5;
  }

  void draw_cells(const MeasuredFace& m) {
    const auto& grid = m.result.grid;
    const Vec2d half(0.5 * grid.width / static_cast<double>(grid.columns),
                     0.5 * grid.height / static_cast<double>(grid.rows));
    for (std::size_t i = 0; i < m.result.light.size(); ++i) {
      const auto middle = grid.middle(grid.cell[i]);
      const auto a = at(m, middle - half), b = at(m, middle + half);
      const auto low = glm::min(a, b), size = glm::abs(b - a);
      text_ += fmt::format(
          "<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"{}\"/>\n", low.x, low.y,
          size.x + 0.3, size.y + 0.3, svg_pale_colour(fraction(m.result.light[i].illuminance)));
    }
  }

  void draw_lines(const MeasuredFace& m) {
    std::vector<double> values;
    for (const auto& light : m.result.light) values.push_back(light.illuminance);
    for (const auto& line : isolux_lines(m.result.grid, values, isolux_levels(low_value_, high_value_))) {
      std::string path;
      double length = 0.0;
      Vec2d last{0.0};
      for (const auto& p : line.points) {
        const auto q = at(m, p);
        length += path.empty() ? 0.0 : glm::length(q - last);
        path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", q.x, q.y);
        last = q;
      }
      text_ += fmt::format(
          "<path class=\"isolux\" d=\"{}{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.1\"/>\n", path,
          line.is_closed ? "Z" : "", svg_colour(fraction(line.level)));
      labels_.push_back({length, at(m, line.points[line.points.size() / 2]), line.level});
    }
  }

  void draw_outline_and_name(const MeasuredFace& m) {
    std::string path;
    Vec2d middle(0.0);
    for (const auto& corner : m.face.area.polygon) {
      const auto q = at(m.face, corner);
      path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", q.x, q.y);
      middle += 0.25 * q;
    }
    text_ += fmt::format("<path d=\"{}Z\" fill=\"none\" stroke=\"#333\" stroke-width=\"1.4\"/>\n", path);
    const auto name = m.face.area.name, mean = svg_lux(m.result.mean.value) + " lx";
    const auto half =
        0.5 * svg_letter * svg_text_size * static_cast<double>(std::max(name.size(), mean.size()));
    taken_.push_back({middle.x - half, middle.y - 16.0, middle.x + half, middle.y + 16.0});
    text_ += svg_text(name, middle - Vec2d(0.0, 8.0), "middle", "#111", "bold") +
             svg_text(mean, middle + Vec2d(0.0, 8.0), "middle", "#111");
  }

  // The longest lines first; a label that would meet another one is left out.
  void draw_labels() {
    std::stable_sort(labels_.begin(), labels_.end(),
                     [](const Label& a, const Label& b) { return a.length > b.length; });
    constexpr double size = 10.0, min_length = 60.0;  // pixels
    for (const auto& label : labels_) {
      const auto number = svg_lux(label.level);
      const auto half = 0.5 * svg_letter * size * static_cast<double>(number.size()) + 2.0;
      const std::array<double, 4> box = {label.at.x - half, label.at.y - 0.6 * size, label.at.x + half,
                                         label.at.y + 0.6 * size};
      if (label.length < min_length || std::any_of(taken_.begin(), taken_.end(), [&](const auto& other) {
            return box[0] < other[2] && box[2] > other[0] && box[1] < other[3] && box[3] > other[1];
          }))
        continue;
      taken_.push_back(box);
      text_ += fmt::format(
          "<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"{}\" text-anchor=\"middle\" fill=\"#111\" "
          "stroke=\"#fff\" "
          "stroke-width=\"2.5\" paint-order=\"stroke\">{}</text>\n",
          label.at.x, label.at.y + 0.35 * size, size, number);
    }
  }

  void draw_legend() {
    constexpr int steps = 40;
    constexpr double bar = 300.0, height = 12.0;  // pixels
    const auto x = svg_margin, y = bottom_ + 16.0;
    for (int i = 0; i < steps; ++i)
      text_ +=
          fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{}\" fill=\"{}\"/>\n",
                      x + bar * i / steps, y, bar / steps + 0.4, height, svg_pale_colour((i + 0.5) / steps));
    for (const double part : {0.0, 0.5, 1.0})
      text_ += svg_text(svg_lux(low_value_ + part * (high_value_ - low_value_)),
                        {x + part * bar, y + height + 10.0},
                        part == 0.0   ? "start"
                        : part == 1.0 ? "end"
                                      : "middle",
                        "#333");
    text_ += svg_text("illuminance in lx, " + faces_[0].result.maintenance().text(),
                      {width - svg_margin, y + 6.0}, "end", "#333");
  }

  struct Label {
    double length = 0.0;  // of the line, pixels
    Vec2d at{0.0};
    double level = 0.0;
  };

  const UnfoldedRoom& faces_;
  UnfoldedSheet sheet_;
  double low_value_ = std::numeric_limits<double>::infinity(), high_value_ = 0.0;  // lx
  Vec2d low_{0.0};                                                                 // m, of the sheet
  double scale_ = 1.0, left_ = 0.0, bottom_ = 0.0;                                 // pixels per m; pixels
  std::vector<Label> labels_;
  std::vector<std::array<double, 4>> taken_;  // pixels: boxes of text
  std::string text_;
};

// Names a wall by its direction on the plan, as the places of observers are named.
std::string wall_name(const RoomEdge& edge) {
  const auto out = edge.outwards();
  if (std::abs(out.x) > std::abs(out.y)) return out.x > 0.0 ? "right wall" : "left wall";
  return out.y > 0.0 ? "upper wall" : "lower wall";
}

}  // namespace

std::vector<RoomFace> faces_of(const RoomData& room, const PatchSet& patches) {
  std::vector<RoomFace> faces;
  const auto height = room.high.z - room.low.z;
  if (!is_rectangle(room) || !(height > 0.0)) return faces;
  const auto add = [&](RoomFace face, const char* name, const std::vector<std::uint32_t>& surface,
                       double size) {
    if (summed_area(patches, surface) < min_covered * size) return;
    face.area.name = name;
    faces.push_back(std::move(face));
  };
  add({RoomFaceKind::floor, 0, level_area(room, room.low.z + in_front, true)}, "floor", room.floor,
      room.floor_area);
  for (std::size_t i = 0; i < 4; ++i) {
    const auto edge = edge_of(room, i);
    add({RoomFaceKind::wall, i, upright_area(room, edge)}, wall_name(edge).c_str(),
        patches_of(room, patches, edge), height * glm::length(edge.to - edge.from));
  }
  add({RoomFaceKind::ceiling, 0, level_area(room, room.high.z - in_front, false)}, "ceiling", room.ceiling,
      room.floor_area);
  return faces;
}

std::string unfolded_svg(const UnfoldedRoom& faces, const RoomData& room) {
  return Unfolded(faces, room).svg();
}

}  // namespace luxel
