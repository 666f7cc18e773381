// SPDX-License-Identifier: Apache-2.0
#include "luxel/lighting/svg_parts.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace luxel {
namespace {

constexpr double line_height = 16.0;  // pixels

std::string name_of(const PlaneResult& result, const PlaneDrawing& drawing) {
  return drawing.title.empty() ? result.area.name : drawing.title;
}

std::string figures_of(const PlaneResult& r) {
  return fmt::format("mean {} lx · min {} lx · max {} lx · U0 {:.2f}", svg_lux(r.mean.value),
                     svg_lux(r.min.value), svg_lux(r.max.value), r.min_over_mean.value);
}

bool is_one_line(const PlaneResult& result, const PlaneDrawing& drawing) {
  constexpr double bold = 1.15;  // width of bold text over that of normal text
  const auto letters = bold * static_cast<double>(name_of(result, drawing).size()) +
                       static_cast<double>(figures_of(result).size());
  return letters * svg_letter * svg_text_size < drawing.width - 3.0 * svg_margin;
}

std::string mixed_colour(double fraction, double white) {
  constexpr std::array<std::array<double, 3>, 5> stops = {
      {{45, 52, 120}, {29, 105, 150}, {24, 135, 95}, {178, 120, 10}, {190, 45, 20}}};
  const auto place = std::clamp(fraction, 0.0, 1.0) * static_cast<double>(stops.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(place), stops.size() - 2);
  const auto t = place - static_cast<double>(i);
  const auto mix = [&](std::size_t k) {
    return static_cast<int>(255.0 * white + (1.0 - white) * ((1.0 - t) * stops[i][k] + t * stops[i + 1][k]));
  };
  return fmt::format("#{:02x}{:02x}{:02x}", mix(0), mix(1), mix(2));
}

}  // namespace

std::string svg_escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else if (static_cast<unsigned char>(c) >= 0x20)
      result += c;
  }
  return result;
}

std::string svg_lux(double lux) {
  if (lux >= 100.0) return fmt::format("{:.0f}", lux);
  if (lux >= 10.0) return fmt::format("{:.3g}", lux);
  return lux >= 0.01 ? fmt::format("{:.2g}", lux) : lux > 0.0 ? fmt::format("{:.3f}", lux) : "0";
}

double round_length(double length) {
  const auto power = std::pow(10.0, std::floor(std::log10(length)));
  return length >= 5.0 * power ? 5.0 * power : length >= 2.0 * power ? 2.0 * power : power;
}

std::string svg_colour(double fraction) { return mixed_colour(fraction, 0.0); }

std::string svg_pale_colour(double fraction) {
  constexpr double white = 0.62;  // part of white: black text stays readable on it
  return mixed_colour(fraction, white);
}

std::string svg_begin(double width, double height) {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} "
      "{1:.0f}\" font-family=\"Helvetica, Arial, sans-serif\" font-size=\"{2}\">\n"
      "<rect width=\"{0:.0f}\" height=\"{1:.0f}\" fill=\"#fff\"/>\n",
      width, height, svg_text_size);
}

std::string svg_text(const std::string& text, const Vec2d& at, const char* anchor, const std::string& fill,
                     const char* weight) {
  return fmt::format(
      "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" fill=\"{}\" font-weight=\"{}\">{}</text>\n", at.x,
      at.y + 0.35 * svg_text_size, anchor, fill, weight, svg_escaped(text));
}

double svg_head(const PlaneResult& result, const PlaneDrawing& drawing) {
  return is_one_line(result, drawing) ? 34.0 : 34.0 + line_height;
}

std::string svg_title(const PlaneResult& result, const PlaneDrawing& drawing) {
  constexpr double first = 17.0;  // pixels: the middle of the first line
  auto text = svg_text(name_of(result, drawing), {svg_margin, first}, "start", "#111", "bold");
  if (is_one_line(result, drawing))
    return text + svg_text(figures_of(result), {drawing.width - svg_margin, first}, "end", "#333");
  return text + svg_text(figures_of(result), {svg_margin, first + line_height}, "start", "#333");
}

}  // namespace luxel
