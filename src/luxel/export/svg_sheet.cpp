// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/svg_sheet.h"

#include <algorithm>

#include <fmt/format.h>

namespace luxel {
namespace {

constexpr double page_width = 680.0, max_height = 300.0;  // units

}  // namespace

SvgSheet::SvgSheet(const PlanPoint& low, const PlanPoint& high, double below) : low_(low), below_(below) {
  const auto size = glm::max(high - low, PlanPoint(1e-3));
  scale_ = std::min((page_width - 2.0 * margin) / size.x, max_height / size.y);
  bottom_ = margin + scale_ * size.y;
  right_ = margin + scale_ * size.x;
}

PlanPoint SvgSheet::at(const PlanPoint& place) const {
  return {margin + scale_ * (place.x - low_.x), bottom_ - scale_ * (place.y - low_.y)};
}

std::string SvgSheet::path_of(std::span<const PlanPoint> loop) const {
  std::string path;
  for (const auto& corner : loop) {
    const auto p = at(corner);
    path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", p.x, p.y);
  }
  return path + "Z";
}

std::string SvgSheet::begin(const std::string& title) const {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:.1f} {:.1f}\" role=\"img\" "
      "style=\"max-width:{:.1f}px\" font-family=\"Helvetica, Arial, sans-serif\">\n<title>{}</title>\n",
      right_ + margin, bottom_ + below_, right_ + margin, title);
}

std::string svg_text(const PlanPoint& at, const std::string& text, double size,
                     const std::string& attributes) {
  return fmt::format(
      "<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"{:.1f}\" text-anchor=\"middle\" "
      "dominant-baseline=\"central\"{}{}>{}</text>\n",
      at.x, at.y, size, attributes.empty() ? "" : " ", attributes, text);
}

std::string svg_line(const PlanPoint& from, const PlanPoint& to, const std::string& attributes) {
  return fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" {}/>\n", from.x, from.y,
                     to.x, to.y, attributes);
}

}  // namespace luxel
