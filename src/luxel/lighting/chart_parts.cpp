// SPDX-License-Identifier: Apache-2.0
#include "luxel/lighting/chart_parts.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "luxel/image/false_colours.h"
#include "luxel/lighting/svg_parts.h"

namespace luxel {

double ColourScale::fraction(double number) const {
  if (!std::isfinite(number)) return 0.0;
  if (is_logarithmic) {
    if (!(number > low)) return 0.0;
    return std::min(1.0, std::log(number / low) / std::log(high / low));
  }
  return std::clamp((number - low) / (high - low), 0.0, 1.0);
}

std::string ColourScale::colour(double number) const {
  const auto code = false_colour(fraction(number));
  const auto byte = [](float c) { return static_cast<int>(std::lround(255.0 * static_cast<double>(c))); };
  return fmt::format("#{:02x}{:02x}{:02x}", byte(code.r), byte(code.g), byte(code.b));
}

const char* ColourScale::text_colour(double number) const {
  constexpr double bright = 0.58;  // from where on black has the higher contrast on these colours
  return fraction(number) > bright ? "#000" : "#fff";
}

std::string scale_number(double number) {
  if (std::abs(number) < 1000.0) return fmt::format("{:.4g}", number);
  const auto thousands = std::lround(number) / 1000, rest = std::lround(number) % 1000;
  return fmt::format("{},{:03}", thousands, std::abs(rest));
}

std::string legend_svg(const ColourScale& scale, double x, double y, double width) {
  constexpr int steps = 64;
  constexpr double bar = 10.0;  // pixels: height
  std::string svg;
  for (int i = 0; i < steps; ++i) {
    const auto part = (i + 0.5) / steps;
    const auto number = scale.is_logarithmic ? scale.low * std::pow(scale.high / scale.low, part)
                                             : scale.low + part * (scale.high - scale.low);
    svg += fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:g}\" fill=\"{}\" "
        "shape-rendering=\"crispEdges\"/>\n",
        x + width * i / steps, y, width / steps + 0.6, bar, scale.colour(number));
  }
  for (std::size_t i = 0; i < scale.marks.size(); ++i) {
    const auto mark = scale.marks[i];
    const auto at = x + width * scale.fraction(mark);
    svg += fmt::format("<path d=\"M{:.1f} {:.1f}v4\" stroke=\"#333\"/>\n", at, y + bar);
    const bool is_last = i + 1 == scale.marks.size();
    svg += svg_text(is_last ? fmt::format("{} {}", scale_number(mark), scale.unit) : scale_number(mark),
                    {at, y + bar + 11.0}, "middle", "#333");
  }
  return svg;
}

namespace {

constexpr double first_line = 15.0, next_line = 16.0;  // pixels

}  // namespace

std::string chart_title_svg(const std::string& title, const std::vector<std::string>& figures, double x) {
  auto svg = svg_text(title, {x, first_line}, "start", "#111", "bold");
  for (std::size_t i = 0; i < figures.size(); ++i)
    svg += svg_text(figures[i], {x, first_line + next_line * static_cast<double>(i + 1)}, "start", "#333");
  return svg;
}

double chart_title_height(std::size_t figures) {
  return 2.0 * first_line + next_line * static_cast<double>(figures);
}

}  // namespace luxel
