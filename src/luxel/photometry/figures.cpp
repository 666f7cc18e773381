// SPDX-License-Identifier: Apache-2.0
#include "luxel/photometry/figures.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "luxel/core/trig.h"

namespace luxel {
namespace {

// Degrees between the samples of a plane; crossings between two are interpolated. Files have 0.5 degrees at
// the finest.
constexpr double step = 0.05;

std::vector<double> clipped(const std::vector<double>& angles, double low, double high) {
  std::vector<double> inside;
  const auto add_limit = [&](double limit) {
    if (angles.front() <= limit && limit <= angles.back()) inside.push_back(limit);
  };
  add_limit(low);
  for (const auto a : angles)
    if (a > low && a < high) inside.push_back(a);
  add_limit(high);
  return inside;
}

// lm of the directions below the horizontal, by the zonal rule.
double downward_flux(const IntensityDistribution& intensity) {
  auto vertical = intensity.vertical(), horizontal = intensity.horizontal();
  switch (intensity.type()) {
    case GoniometerType::c:
      vertical = clipped(vertical, 0.0, 90.0);
      break;
    case GoniometerType::b:
      vertical = clipped(vertical, -90.0, 90.0);
      break;
    case GoniometerType::a:
      horizontal = clipped(horizontal, -90.0, 90.0);
      break;
  }
  if (vertical.size() < 2 || (intensity.type() != GoniometerType::c && horizontal.size() < 2)) return 0.0;
  std::vector<double> candela;
  for (const auto h : horizontal)
    for (const auto v : vertical) candela.push_back(intensity.at_angles(v, h));
  return IntensityDistribution(intensity.type(), vertical, horizontal, candela).zonal_flux();
}

// The values of a plane around `axis`, the index of the aim or of the direction opposite to it.
class Around {
 public:
  Around(const std::vector<double>& values, int axis)
      : values_(values), axis_(axis), half_(static_cast<int>(values.size()) / 2) {}

  // The outermost angle with at least `level` on one side (1 or -1), in steps from the axis: sought from the
  // horizontal inwards or, where the light there is that bright, outwards.
  double outermost(int side, double level) const {
    auto k = half_ / 2;
    if (at(side * k) >= level)
      while (k < half_ && at(side * (k + 1)) >= level) ++k;
    else
      while (k > -half_ / 2 && at(side * k) < level) --k;
    if (k == half_) return side * k;
    const auto inside = at(side * k), outside = at(side * (k + 1));
    return side * (k + std::clamp((inside - level) / (inside - outside), 0.0, 1.0));
  }

 private:
  double at(int k) const {
    const auto count = 2 * half_;
    return values_[static_cast<std::size_t>((axis_ + k + count) % count)];
  }

  const std::vector<double>& values_;
  int axis_, half_;
};

PlaneFigures figures_of(const IntensityDistribution& intensity, MainPlane plane) {
  const auto count = static_cast<std::size_t>(std::lround(360.0 / step));
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto angle = static_cast<double>(i) * step;
    values[i] = intensity_in_plane(intensity, plane, i > count / 2 ? angle - 360.0 : angle);
  }
  const auto peak = std::max_element(values.begin(), values.end());
  PlaneFigures figures;
  figures.maximum = *peak;
  if (!(figures.maximum > 0.0)) return figures;
  const auto index = static_cast<std::size_t>(peak - values.begin());
  const bool is_above = index > count / 4 && index < count - count / 4;
  const Around around(values, is_above ? static_cast<int>(count / 2) : 0);
  const auto width = [&](double part) {
    const auto level = part * figures.maximum;
    return step * (around.outermost(1, level) - around.outermost(-1, level));
  };
  figures.beam_angle = width(0.5);
  figures.field_angle = width(0.1);
  return figures;
}

}  // namespace

double intensity_in_plane(const IntensityDistribution& intensity, MainPlane plane, double angle) {
  if (intensity.type() == GoniometerType::c) {
    const auto around = plane == MainPlane::x ? 0.0 : 90.0;
    return intensity.at_angles(std::abs(angle), angle < 0.0 ? around + 180.0 : around);
  }
  const auto t = sin_cos(angle * std::numbers::pi / 180.0);
  return intensity.at(plane == MainPlane::x ? Vec3d(t.sine, 0.0, -t.cosine) : Vec3d(0.0, t.sine, -t.cosine));
}

std::string name_of_plane(GoniometerType type, MainPlane plane) {
  if (type == GoniometerType::c) return plane == MainPlane::x ? "C0-C180" : "C90-C270";
  return plane == MainPlane::x ? "horizontal" : "vertical";
}

PhotometricFigures photometric_figures(const IntensityDistribution& intensity) {
  PhotometricFigures figures;
  if (intensity.candela().empty()) return figures;
  figures.x = figures_of(intensity, MainPlane::x);
  figures.y = figures_of(intensity, MainPlane::y);
  const auto flux = intensity.zonal_flux();
  if (flux > 0.0) figures.downward_fraction = std::min(1.0, downward_flux(intensity) / flux);
  const auto& candela = intensity.candela();
  const auto peak =
      static_cast<std::size_t>(std::max_element(candela.begin(), candela.end()) - candela.begin());
  const auto rows = intensity.vertical().size();
  figures.vertical = intensity.vertical()[peak % rows];
  figures.horizontal = intensity.horizontal()[peak / rows];
  return figures;
}

}  // namespace luxel
