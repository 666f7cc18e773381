// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/core/trig.h"
#include "luxel/photometry/photometry.h"

namespace luxel {
namespace {

constexpr double degrees = 180.0 / std::numbers::pi;

void check_angles(const std::vector<double>& angles, const char* kind) {
  if (angles.empty()) throw InputError(fmt::format("expected at least one {} angle, found none", kind));
  for (std::size_t i = 0; i < angles.size(); ++i) {
    if (!std::isfinite(angles[i]) || std::abs(angles[i]) > 360.0)
      throw InputError(fmt::format("expected {} angles within 360 degrees, found {:g}", kind, angles[i]));
    if (i > 0 && !(angles[i] > angles[i - 1]))
      throw InputError(
          fmt::format("expected ascending {} angles, found {:g} after {:g}", kind, angles[i], angles[i - 1]));
  }
}

void check_range(const std::vector<double>& angles, const char* kind, double low, double high) {
  if (angles.front() < low || angles.back() > high)
    throw InputError(fmt::format("expected {} angles of {:g} to {:g} degrees, found {:g} to {:g}", kind, low,
                                 high, angles.front(), angles.back()));
}

// The latitude covers half a turn, the angle around it a whole one; types A and B have a range of both.
void check_ranges(GoniometerType type, const std::vector<double>& vertical,
                  const std::vector<double>& horizontal) {
  using enum GoniometerType;
  if (vertical.size() < 2) throw InputError("expected at least two vertical angles, found one");
  if (type == c) {
    check_range(vertical, "vertical", 0.0, 180.0);
    return check_range(horizontal, "horizontal", 0.0, 360.0);
  }
  if (horizontal.size() < 2)
    throw InputError("expected at least two horizontal angles in types A and B, found one");
  check_range(vertical, "vertical", type == a ? -90.0 : -180.0, type == a ? 90.0 : 180.0);
  check_range(horizontal, "horizontal", type == b ? -90.0 : -180.0, type == b ? 90.0 : 180.0);
}

// The interval of ascending angles that holds x, and the place in it, 0 to 1.
struct Interval {
  std::size_t first = 0;
  double place = 0.0;
};

Interval interval_at(const std::vector<double>& angles, double x) {
  if (angles.size() == 1) return {};
  const auto last = angles.size() - 2;  // interval
  // Most files have equal steps: then this is the interval, or the next one by rounding. Others are searched.
  const auto steps = (x - angles.front()) / (angles.back() - angles.front()) * static_cast<double>(last + 1);
  auto first = static_cast<std::size_t>(std::min(std::max(0.0, steps), static_cast<double>(last)));
  if ((first > 0 && x < angles[first]) || (first < last && x >= angles[first + 1])) {
    const auto next = std::upper_bound(angles.begin() + 1, angles.end() - 1, x);
    first = static_cast<std::size_t>(next - angles.begin()) - 1;
  }
  return {first, std::clamp((x - angles[first]) / (angles[first + 1] - angles[first]), 0.0, 1.0)};
}

double wrapped(double angle) {
  const auto turns = std::floor(angle / 360.0);
  return angle - 360.0 * turns;
}

// Integral of the linear function from a at x0 to b at x1 times sin(x), radians.
double times_sine(double x0, double x1, double a, double b) {
  // Closer angles would cancel below; the error is a fraction of 1e-9 here.
  if (x1 - x0 < 1e-4) return 0.5 * (a + b) * (x1 - x0) * sin_cos(0.5 * (x0 + x1)).sine;
  const auto at0 = sin_cos(x0), at1 = sin_cos(x1);
  const auto slope = (b - a) / (x1 - x0);
  return a * at0.cosine - b * at1.cosine + slope * (at1.sine - at0.sine);
}

// Weight of each angle in the mean over all planes by the trapezoidal rule; sums to 1.
std::vector<double> plane_weights(const std::vector<double>& angles) {
  if (angles.size() == 1) return {1.0};
  std::vector<double> weights(angles.size(), 0.0);
  const auto range = angles.back() - angles.front();
  for (std::size_t i = 0; i + 1 < angles.size(); ++i) {
    const auto half = 0.5 * (angles[i + 1] - angles[i]) / range;
    weights[i] += half;
    weights[i + 1] += half;
  }
  return weights;
}

}  // namespace

IntensityDistribution::IntensityDistribution(GoniometerType type, std::vector<double> vertical,
                                             std::vector<double> horizontal, std::vector<double> candela)
    : type_(type),
      vertical_(std::move(vertical)),
      horizontal_(std::move(horizontal)),
      candela_(std::move(candela)) {
  check_angles(vertical_, "vertical");
  check_angles(horizontal_, "horizontal");
  if (candela_.size() != vertical_.size() * horizontal_.size())
    throw InputError(fmt::format("expected {} x {} values of candela, found {}", horizontal_.size(),
                                 vertical_.size(), candela_.size()));
  for (const auto value : candela_)
    if (!(value >= 0.0 && value <= 1e30))
      throw InputError(fmt::format("expected candela of 0 to 1e30, found {:g}", value));
  check_ranges(type_, vertical_, horizontal_);
  if (type_ == GoniometerType::c) close_planes();
  maximum_ = *std::max_element(candela_.begin(), candela_.end());
  find_fluxes();
  find_zones();
}

void IntensityDistribution::find_zones() {
  constexpr int heights = 4, turns = 24;  // directions in a zone
  for (int zone = 0; zone < zones; ++zone)
    for (int i = 0; i <= heights; ++i)
      for (int j = 0; j < turns; ++j) {
        const auto z = std::clamp(2.0 * (heights * zone + i) / (heights * zones) - 1.0, -1.0, 1.0);
        const auto radius = std::sqrt(std::max(0.0, 1.0 - z * z));
        const auto turn = sin_cos(2.0 * std::numbers::pi * j / turns);
        auto& maximum = zone_maxima_[static_cast<std::size_t>(zone)];
        maximum = std::max(maximum, at({radius * turn.cosine, radius * turn.sine, z}));
      }
}

// Planes around without symmetry go from 0 to 360, so that they can be given to the constructor again: 360 is
// 0, or what lies between the last plane and the first.
void IntensityDistribution::close_planes() {
  const auto first = horizontal_.front(), last = horizontal_.back();
  if (!(last > 180.0) || last >= 360.0 || first >= 90.0) return;
  const auto rows = vertical_.size();
  const auto place = (360.0 - last) / (first + 360.0 - last);
  std::vector<double> plane(rows);
  for (std::size_t i = 0; i < rows; ++i) {
    const auto before = candela_[candela_.size() - rows + i];
    plane[i] = first == 0.0 ? candela_[i] : before + place * (candela_[i] - before);
  }
  if (first > 0.0) {
    horizontal_.insert(horizontal_.begin(), 0.0);
    candela_.insert(candela_.begin(), plane.begin(), plane.end());
  }
  horizontal_.push_back(360.0);
  candela_.insert(candela_.end(), plane.begin(), plane.end());
}

void IntensityDistribution::find_fluxes() {
  // The latitude runs along the vertical angles but in type B, where it is the horizontal one.
  const bool is_b = type_ == GoniometerType::b;
  const auto& along = is_b ? horizontal_ : vertical_;
  const auto& around = is_b ? vertical_ : horizontal_;
  const auto at = [&](std::size_t i, std::size_t j) {  // i: along, j: around
    return candela_[is_b ? i * vertical_.size() + j : j * vertical_.size() + i];
  };
  auto weights = plane_weights(around);
  // Types A and B: planes cover their own range, twice that where 0 is a plane of symmetry.
  double turn = 2.0 * std::numbers::pi, mirrored = 1.0;
  if (type_ != GoniometerType::c) {
    turn = (around.back() - around.front()) / degrees * (around.front() >= 0.0 ? 2.0 : 1.0);
    mirrored = along.front() >= 0.0 ? 2.0 : 1.0;
  }
  const auto to_polar = [&](double angle) {
    return (type_ == GoniometerType::c ? angle : angle + 90.0) / degrees;
  };
  for (std::size_t i = 0; i + 1 < along.size(); ++i) {
    double low = 0.0, high = 0.0;
    for (std::size_t j = 0; j < around.size(); ++j) {
      low += weights[j] * at(i, j);
      high += weights[j] * at(i + 1, j);
    }
    const auto x0 = to_polar(along[i]), x1 = to_polar(along[i + 1]);
    linear_flux_ += mirrored * turn * times_sine(x0, x1, low, high);
    zonal_flux_ += mirrored * turn * 0.5 * (low + high) * (sin_cos(x0).cosine - sin_cos(x1).cosine);
  }
}

double IntensityDistribution::at_angles(double vertical, double horizontal) const {
  if (candela_.empty()) return 0.0;
  constexpr double tolerance = 1e-9;  // degrees: of a direction that was computed from an angle
  auto v = vertical;
  auto h = horizontal;
  const auto last = horizontal_.back();
  if (type_ == GoniometerType::c) {
    h = wrapped(h);
    if (horizontal_.size() == 1) {
      h = horizontal_.front();
    } else if (last <= 180.0) {  // mirrored about the plane of 0 and 180, a quadrant about that of 90 too
      if (h > 180.0) h = 360.0 - h;
      if (last <= 90.0 && h > 90.0) h = 180.0 - h;
    } else if (horizontal_.front() >= 90.0) {  // mirrored about the plane of 90 and 270
      if (h < 90.0) h = 180.0 - h;
      if (h > 270.0) h = 540.0 - h;
    }
  } else {
    if (horizontal_.front() >= 0.0) h = std::abs(h);
    if (vertical_.front() >= 0.0) v = std::abs(v);
    if (horizontal_.size() > 1 && (h < horizontal_.front() - tolerance || h > last + tolerance)) return 0.0;
  }
  if (v < vertical_.front() - tolerance || v > vertical_.back() + tolerance) return 0.0;
  const auto row = interval_at(vertical_, v), plane = interval_at(horizontal_, h);
  const auto rows = vertical_.size();
  const auto* values = &candela_[plane.first * rows + row.first];
  const auto in_plane = [&](const double* of_plane) {
    return row.place > 0.0 ? of_plane[0] + row.place * (of_plane[1] - of_plane[0]) : of_plane[0];
  };
  const auto first = in_plane(values);
  return plane.place > 0.0 ? first + plane.place * (in_plane(values + rows) - first) : first;
}

double IntensityDistribution::at(const Vec3d& direction) const {
  const auto& d = direction;
  switch (type_) {
    case GoniometerType::c: {
      const auto around =
          horizontal_.size() > 1 ? degrees * arc_tangent(d.y, d.x) : 0.0;  // rotational symmetry needs none
      return at_angles(degrees * arc_tangent(std::sqrt(d.x * d.x + d.y * d.y), -d.z), around);
    }
    case GoniometerType::b:
      return at_angles(degrees * arc_tangent(d.y, -d.z), degrees * arc_tangent(d.x, std::hypot(d.y, d.z)));
    case GoniometerType::a:
      return at_angles(degrees * arc_tangent(d.y, std::hypot(d.x, d.z)), degrees * arc_tangent(d.x, -d.z));
  }
  return 0.0;
}

}  // namespace luxel
