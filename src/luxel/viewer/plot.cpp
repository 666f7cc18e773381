// SPDX-License-Identifier: Apache-2.0
#include "luxel/viewer/plot.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <imgui.h>

#include "luxel/viewer/colour_map.h"
#include "luxel/viewer/layout.h"

namespace luxel {
namespace {

constexpr ImU32 ground = IM_COL32(20, 22, 28, 255), axis = IM_COL32(120, 130, 145, 255),
                curve = IM_COL32(255, 190, 60, 255), band = IM_COL32(255, 190, 60, 60),
                mark = IM_COL32(110, 200, 130, 200), text = IM_COL32(190, 198, 210, 255);

struct Range {
  double low = 1e300, high = -1e300;

  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  double fraction(double value) const { return high > low ? (value - low) / (high - low) : 0.5; }
};

// Maps values to pixels.
struct Chart {
  ImVec2 corner, size;
  Range x, y;
  bool logarithmic;

  double scaled(double value) const { return logarithmic ? std::log10(value) : value; }
  ImVec2 at(double px, double py) const {
    return {corner.x + static_cast<float>(x.fraction(scaled(px))) * size.x,
            corner.y + static_cast<float>(1.0 - std::clamp(y.fraction(scaled(py)), 0.0, 1.0)) * size.y};
  }
};

std::string value_text(double value, const PlotStyle& style, const char* unit) {
  return fmt::format("{}{}", scale_text(static_cast<float>(style.percent ? 100.0 * value : value)), unit);
}

void draw_curve(const Chart& chart, const std::vector<PlotPoint>& points) {
  auto& list = *ImGui::GetWindowDrawList();
  // Smoothed edges of neighbours would overlap and show as stripes.
  const auto flags = std::exchange(list.Flags, list.Flags & ~ImDrawListFlags_AntiAliasedFill);
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const auto &a = points[i], &b = points[i + 1];
    if (a.is_gap || b.is_gap) continue;
    if (a.error > 0.0 || b.error > 0.0)
      list.AddQuadFilled(chart.at(a.x, a.y - a.error), chart.at(b.x, b.y - b.error),
                         chart.at(b.x, b.y + b.error), chart.at(a.x, a.y + a.error), band);
  }
  list.Flags = flags;
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    if (!points[i].is_gap && !points[i + 1].is_gap)
      list.AddLine(chart.at(points[i].x, points[i].y), chart.at(points[i + 1].x, points[i + 1].y), curve,
                   em(0.1f));
  if (points.size() < 30)
    for (const auto& p : points)
      if (!p.is_gap) list.AddCircleFilled(chart.at(p.x, p.y), em(0.17f), curve);
}

}  // namespace

void plot(const std::vector<PlotPoint>& points, const PlotStyle& style) {
  const auto place = ImGui::GetCursorScreenPos();
  const float width = em(style.width), height = em(style.height), margin = em(0.4f);
  ImGui::Dummy(ImVec2(width, height));
  auto& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(place, ImVec2(place.x + width, place.y + height), ground, em(0.2f));
  const float line = ImGui::GetTextLineHeight();
  Chart chart{ImVec2(place.x + margin, place.y + 0.7f * margin),
              ImVec2(width - 2.0f * margin, height - line - 1.4f * margin),
              {},
              {},
              style.logarithmic};
  std::vector<PlotPoint> shown;
  for (const auto& p : points) {
    if (style.logarithmic && !(p.x > 0.0 && p.y > 0.0)) continue;
    shown.push_back(p);
    if (p.is_gap) continue;
    chart.x.add(chart.scaled(p.x));
    chart.y.add(chart.scaled(p.y + p.error));
    if (!style.logarithmic)
      chart.y.add(std::max(0.0, p.y - p.error));
    else
      chart.y.add(chart.scaled(p.y));
  }
  if (!(chart.x.low <= chart.x.high)) return;
  if (style.line > 0.0) chart.y.add(chart.scaled(style.line));
  if (!style.logarithmic && chart.y.low < 0.5 * chart.y.high) chart.y.low = 0.0;
  if (style.line > 0.0) {
    const float y = chart.at(1.0, style.line).y;
    list.AddLine(ImVec2(chart.corner.x, y), ImVec2(chart.corner.x + chart.size.x, y), mark);
  }
  draw_curve(chart, shown);
  const auto number = [&](double value) { return style.logarithmic ? std::pow(10.0, value) : value; };
  const auto& y = chart.y;
  list.AddText(ImVec2(chart.corner.x, chart.corner.y), text,
               value_text(number(y.high), style, style.y_unit).c_str());
  list.AddText(ImVec2(chart.corner.x, chart.corner.y + chart.size.y - line), text,
               value_text(number(y.low), style, style.y_unit).c_str());
  const auto right = fmt::format("{} {}", scale_text(static_cast<float>(number(chart.x.high))), style.x_unit);
  list.AddText(ImVec2(place.x + width - ImGui::CalcTextSize(right.c_str()).x - margin,
                      place.y + height - line - em(0.14f)),
               axis, right.c_str());
}

}  // namespace luxel
