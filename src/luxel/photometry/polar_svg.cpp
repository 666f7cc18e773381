// SPDX-License-Identifier: Apache-2.0
#include "luxel/photometry/polar_svg.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "luxel/core/trig.h"
#include "luxel/photometry/figures.h"

namespace luxel {
namespace {

constexpr double width = 360.0;
constexpr double radius = 140.0;  // of the outer circle
constexpr double middle = 180.0;  // x of the pole
constexpr double top = 26.0;      // room for the labels of angles
constexpr double legend = 56.0;   // height of it and of the labels above it
// Below this fraction of the maximum, light upwards is not drawn.
constexpr double negligible = 0.02;
constexpr double widest_step = 2.0;  // degrees between points of a curve

constexpr const char* ink = "#24292f";
constexpr const char* quiet = "#5c636e";
constexpr const char* grid = "#d4d8de";
constexpr const char* colours[] = {"#b3273f", "#1f66d0"};
constexpr const char* dashes[] = {"", " stroke-dasharray=\"7 4\""};

std::string escaped(std::string_view text) {
  std::string safe;
  for (const auto c : text) {
    if (c == '&')
      safe += "&amp;";
    else if (c == '<')
      safe += "&lt;";
    else if (c == '>')
      safe += "&gt;";
    else
      safe += c;
  }
  return safe;
}

// Between circles: 1, 2, 2.5 or 5 times a power of ten, for 3 to 6 circles.
double nice_step(double maximum) {
  const auto decade = std::pow(10.0, std::floor(std::log10(maximum / 3.0)));
  for (const auto step : {1.0, 2.0, 2.5, 5.0, 10.0})
    if (maximum / (step * decade) <= 5.0) return step * decade;
  return 10.0 * decade;
}

struct Diagram {
  const IntensityDistribution& intensity;
  double scale = 1.0;  // from cd to the unit of the circles
  double step = 1.0;   // between circles, in that unit
  int circles = 1;
  double pole = 0.0;  // y of the pole
  bool has_upper = false;
  std::string svg = {};

  double x(double angle, double r) const {
    return middle + r * sin_cos(angle * std::numbers::pi / 180.0).sine;
  }
  double y(double angle, double r) const {
    return pole + r * sin_cos(angle * std::numbers::pi / 180.0).cosine;
  }
  double outermost() const { return has_upper ? 180.0 : 105.0; }
};

bool has_light_above(const IntensityDistribution& intensity) {
  for (const auto plane : {MainPlane::x, MainPlane::y})
    for (int angle = 91; angle <= 180; ++angle)
      for (const int side : {1, -1})
        if (intensity_in_plane(intensity, plane, side * angle) > negligible * intensity.maximum())
          return true;
  return false;
}

void draw_grid(Diagram& d) {
  for (int i = 1; i <= d.circles; ++i) {
    const auto r = radius * i / d.circles;
    if (d.has_upper)
      d.svg += fmt::format("<circle cx=\"{:g}\" cy=\"{:.1f}\" r=\"{:.1f}\"/>\n", middle, d.pole, r);
    else
      d.svg += fmt::format("<path d=\"M{:.1f} {:.1f}A{:.1f} {:.1f} 0 1 0 {:.1f} {:.1f}\"/>\n", d.x(-105.0, r),
                           d.y(-105.0, r), r, r, d.x(105.0, r), d.y(105.0, r));
  }
  const int last = d.has_upper ? 180 : 105;
  for (int angle = -last + (d.has_upper ? 15 : 0); angle <= last; angle += 15) {
    const auto inner = angle % 90 == 0 ? 0.0 : radius / d.circles;
    d.svg += fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\"/>\n", d.x(angle, inner), d.y(angle, inner),
                         d.x(angle, radius), d.y(angle, radius));
  }
}

void label_angles(Diagram& d) {
  const int last = d.has_upper ? 180 : 90;
  for (int angle = -last + (d.has_upper ? 30 : 0); angle <= last; angle += 30)
    d.svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\">{}°</text>\n", d.x(angle, radius + 14.0),
                         d.y(angle, radius + 12.0) + 4.0, std::abs(angle));
}

// In the unit of the circles; on the axis downwards, or upwards where all the light goes there.
void label_circles(Diagram& d) {
  for (int i = 1; i <= d.circles; ++i)
    d.svg += fmt::format(
        "<text x=\"{:g}\" y=\"{:.1f}\" stroke=\"#ffffff\" stroke-width=\"3\" stroke-linejoin=\"round\" "
        "paint-order=\"stroke\">{:g}</text>\n",
        middle, d.pole + radius * i / d.circles - 3.0, d.step * i);
}

// The angles of the file and no more than widest_step between two.
std::vector<double> curve_angles(const Diagram& d) {
  std::vector<double> angles;
  for (double a = 0.0; a <= d.outermost(); a += widest_step) angles.push_back(a);
  if (d.intensity.vertical().size() <= 1000)
    for (const auto v : d.intensity.vertical())
      if (std::abs(v) <= d.outermost()) angles.push_back(std::abs(v));
  std::sort(angles.begin(), angles.end());
  angles.erase(std::unique(angles.begin(), angles.end()), angles.end());
  std::vector<double> both;
  for (auto i = angles.size(); i-- > 1;) both.push_back(-angles[i]);
  both.insert(both.end(), angles.begin(), angles.end());
  return both;
}

void draw_curve(Diagram& d, MainPlane plane, const std::vector<double>& angles) {
  std::string path;
  for (const auto angle : angles) {
    const auto value = d.scale * intensity_in_plane(d.intensity, plane, angle);
    const auto r = std::min(1.0, value / (d.step * d.circles)) * radius;
    path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", d.x(angle, r), d.y(angle, r));
  }
  const int i = plane == MainPlane::x ? 0 : 1;
  d.svg += fmt::format("<path d=\"{}\" stroke=\"{}\" stroke-width=\"2\" stroke-linejoin=\"round\"{}/>\n",
                       path, colours[i], dashes[i]);
}

bool is_alike_in_all_planes(const IntensityDistribution& intensity) {
  return intensity.type() == GoniometerType::c && intensity.horizontal().size() == 1;
}

void draw_legend(Diagram& d, double y, const char* unit) {
  const auto type = d.intensity.type();
  const bool is_alike = is_alike_in_all_planes(d.intensity);
  const auto entry = [&](int i, double x, const std::string& name) {
    d.svg += fmt::format(
        "<path d=\"M{:g} {:.1f}h26\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\"{}/>"
        "<text x=\"{:g}\" y=\"{:.1f}\">{}</text>\n",
        x, y - 4.0, colours[i], dashes[i], x + 32.0, y, name);
  };
  entry(0, 24.0, is_alike ? "all C planes" : name_of_plane(type, MainPlane::x));
  if (!is_alike) entry(1, 138.0, name_of_plane(type, MainPlane::y));
  d.svg +=
      fmt::format("<text x=\"{:g}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>\n", width - 24.0, y, unit);
}

}  // namespace

std::string polar_svg(const Photometry& photometry) {
  const auto& intensity = photometry.intensity;
  const auto* lamp = photometry.lamp();
  const bool is_relative = !photometry.absolute && lamp && lamp->flux > 0.0;
  Diagram d{intensity};
  d.scale = is_relative ? 1000.0 / lamp->flux : 1.0;
  double maximum = 0.0;
  if (!intensity.candela().empty()) {
    const auto figures = photometric_figures(intensity);
    maximum = d.scale * std::max(figures.x.maximum, figures.y.maximum);
    d.has_upper = has_light_above(intensity);
  }
  d.step = nice_step(maximum > 0.0 ? maximum : 1.0);
  d.circles = std::max(1, static_cast<int>(std::ceil(maximum / d.step - 1e-9)));
  d.pole = top + radius * (d.has_upper ? 1.0 : std::sin(15.0 * std::numbers::pi / 180.0));
  const auto height = d.pole + radius + legend;
  d.svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:g} {1:.0f}\" width=\"{0:g}\" "
      "height=\"{1:.0f}\" role=\"img\" font-family=\"Helvetica,Arial,sans-serif\" font-size=\"11\">\n"
      "<title>Polar diagram{2}</title>\n<rect width=\"{0:g}\" height=\"{1:.0f}\" fill=\"#ffffff\"/>\n",
      width, height, photometry.luminaire.empty() ? "" : ": " + escaped(photometry.luminaire));
  d.svg += fmt::format("<g fill=\"none\" stroke=\"{}\">\n", grid);
  draw_grid(d);
  d.svg += fmt::format("</g>\n<g fill=\"{}\" text-anchor=\"middle\">\n", quiet);
  label_angles(d);
  d.svg += "</g>\n<g fill=\"none\">\n";
  if (!intensity.candela().empty()) {
    const auto angles = curve_angles(d);
    if (!is_alike_in_all_planes(intensity)) draw_curve(d, MainPlane::y, angles);
    draw_curve(d, MainPlane::x, angles);
  }
  d.svg += fmt::format("</g>\n<g fill=\"{}\" text-anchor=\"middle\">\n", quiet);
  label_circles(d);
  d.svg += fmt::format("</g>\n<g fill=\"{}\" font-size=\"12\">\n", ink);
  draw_legend(d, height - 12.0, is_relative ? "cd/klm" : "cd");
  return d.svg + "</g>\n</svg>\n";
}

}  // namespace luxel
