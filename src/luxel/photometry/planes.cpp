// SPDX-License-Identifier: Apache-2.0
#include "luxel/photometry/planes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

#include "luxel/core/error.h"

namespace luxel {
namespace {

constexpr double same_angle = 1e-6;  // degrees; files have at most 4 decimals

bool is_range(const Planes& planes, double first, double last) {
  return std::abs(planes.horizontal.front() - first) < same_angle &&
         std::abs(planes.horizontal.back() - last) < same_angle;
}

// Plane h becomes plane middle - h.
void mirror(Planes& planes, double middle) {
  const auto rows = static_cast<std::ptrdiff_t>(planes.candela.size() / planes.horizontal.size());
  Planes mirrored;
  for (auto i = planes.horizontal.size(); i-- > 0;) {
    mirrored.horizontal.push_back(middle - planes.horizontal[i]);
    const auto first = planes.candela.begin() + static_cast<std::ptrdiff_t>(i) * rows;
    mirrored.candela.insert(mirrored.candela.end(), first, first + rows);
  }
  planes = std::move(mirrored);
}

// Brings all angles to 0..360, in order, each once.
void wrap(Planes& planes) {
  const auto rows = static_cast<std::ptrdiff_t>(planes.candela.size() / planes.horizontal.size());
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < planes.horizontal.size(); ++i) {
    const auto h = planes.horizontal[i];
    order.emplace_back(h < 0.0 ? h + 360.0 : h, i);
  }
  std::sort(order.begin(), order.end());
  Planes wrapped;
  for (const auto& [angle, i] : order) {
    if (!wrapped.horizontal.empty() && angle - wrapped.horizontal.back() < same_angle) continue;
    wrapped.horizontal.push_back(angle);
    const auto first = planes.candela.begin() + static_cast<std::ptrdiff_t>(i) * rows;
    wrapped.candela.insert(wrapped.candela.end(), first, first + rows);
  }
  planes = std::move(wrapped);
}

// Angles next to a multiple of 90 degrees are that.
void snap(double& angle) {
  const auto whole = 90.0 * std::round(angle / 90.0);
  if (std::abs(angle - whole) < same_angle) angle = whole;
}

// Repeats the outer planes of an incomplete quadrant or half at its limits.
std::string complete(Planes& planes) {
  auto& h = planes.horizontal;
  const auto first = h.front(), last = h.back(), end = last < 90.0 ? 90.0 : 180.0;
  const auto rows = static_cast<std::ptrdiff_t>(planes.candela.size() / h.size());
  const std::vector<double> last_plane(planes.candela.end() - rows, planes.candela.end());
  h.push_back(end);
  planes.candela.insert(planes.candela.end(), last_plane.begin(), last_plane.end());
  if (first > 0.0) {
    const std::vector<double> first_plane(planes.candela.begin(), planes.candela.begin() + rows);
    h.insert(h.begin(), 0.0);
    planes.candela.insert(planes.candela.begin(), first_plane.begin(), first_plane.end());
  }
  return fmt::format(
      "horizontal angles {:g} to {:g} are no range of the standard: they are completed to 0 to {:g} by "
      "repeating the "
      "outer planes",
      first, last, end);
}

// Planes all around whose last and first are further apart than others.
std::string gap_around(const std::vector<double>& h) {
  double step = 0.0;
  for (std::size_t i = 0; i + 1 < h.size(); ++i) step = std::max(step, h[i + 1] - h[i]);
  const auto gap = h.front() + 360.0 - h.back();
  if (gap <= 1.5 * step) return {};
  return fmt::format("horizontal angles {:g} to {:g} leave {:g} degrees open, which are interpolated",
                     h.front(), h.back(), gap);
}

// The nearest multiple of a quarter turn, 0 to 3; whether `turn` is one.
std::pair<int, bool> quarters(double turn) {
  const auto count = std::round(turn / 90.0);
  const auto rest = count - 4.0 * std::floor(count / 4.0);
  return {static_cast<int>(rest), std::abs(turn - 90.0 * count) < same_angle};
}

void turn_opening(LuminousOpening& opening, int quarter) {
  if (quarter % 2 == 0) return;
  std::swap(opening.size.x, opening.size.y);
  if (opening.shape == OpeningShape::cylinder_along_x)
    opening.shape = OpeningShape::cylinder_along_y;
  else if (opening.shape == OpeningShape::cylinder_along_y)
    opening.shape = OpeningShape::cylinder_along_x;
}

// A quarter turn anticlockwise seen from above makes type B of type A, and of A's horizontal and vertical
// angles B's vertical and reversed horizontal ones, and the other way round.
IntensityDistribution quarter_turned(const IntensityDistribution& old) {
  const bool is_b = old.type() == GoniometerType::b;
  if (old.vertical().front() < 0.0 && old.vertical().back() <= 0.0)
    throw InputError("vertical angles below 0 only cannot be turned");  // 0 on means mirrored
  const auto reversed = [](const std::vector<double>& angles) {
    std::vector<double> all;
    for (auto i = angles.size(); i-- > 0;) all.push_back(0.0 - angles[i]);
    return all.front() < 0.0 && all.back() <= 0.0 ? angles : all;  // mirrored ranges, 0 to 90, stay
  };
  // Old directions: x = y', y = -x'. Hence the new vertical angle is the old horizontal one, and the new
  // horizontal angle the old vertical one with the other sign.
  const auto vertical = old.horizontal();
  const auto horizontal = reversed(old.vertical());
  std::vector<double> candela;
  for (const auto h : horizontal)
    for (const auto v : vertical) candela.push_back(old.at_angles(-h, v));
  return {is_b ? GoniometerType::a : GoniometerType::b, vertical, horizontal, candela};
}

}  // namespace

std::string standardise(Planes& planes) {
  auto& h = planes.horizontal;
  if (h.size() == 1) return {};
  snap(h.front());
  snap(h.back());
  const auto first = h.front(), last = h.back();
  const auto refuse = [&] {
    throw InputError(fmt::format(
        "expected horizontal angles of 0 to 90, 180 or 360 degrees, found {:g} to {:g}", first, last));
  };
  if (is_range(planes, -90.0, 90.0) || is_range(planes, 180.0, 360.0)) {
    mirror(planes, first < 0.0 ? 180.0 : 360.0);
    return {};
  }
  if (first < 0.0) {
    if (last - first > 360.0 + same_angle || last - first <= 270.0) refuse();
    wrap(planes);
    return {};
  }
  if (is_range(planes, 90.0, 180.0) || is_range(planes, 180.0, 270.0) || is_range(planes, 270.0, 360.0)) {
    if (first == 180.0)
      for (auto& angle : h) angle -= 180.0;
    else
      mirror(planes, last);
    return fmt::format("horizontal angles {:g} to {:g} are taken as a quadrant of a symmetric luminaire",
                       first, last);
  }
  if (is_range(planes, 0.0, 90.0) || is_range(planes, 0.0, 180.0) || is_range(planes, 90.0, 270.0)) return {};
  if (first >= 90.0) refuse();
  return last > 180.0 ? gap_around(h) : complete(planes);
}

Planes all_around(const IntensityDistribution& distribution, double turn) {
  std::vector<double> angles = {0.0, 360.0};
  const auto add = [&](double angle) {
    angle += turn;
    angles.push_back(angle - 360.0 * std::floor(angle / 360.0));
  };
  const auto& given = distribution.horizontal();
  for (const auto h : given) {
    add(h);
    if (given.size() == 1 || given.back() > 270.0) continue;
    // Mirrored planes; those that repeat a given one are dropped below.
    add(given.front() >= 90.0 ? 180.0 - h : -h);
    if (given.back() > 90.0) continue;
    add(180.0 - h);
    add(180.0 + h);
  }
  std::sort(angles.begin(), angles.end());
  Planes planes;
  for (const auto angle : angles) {
    if (!planes.horizontal.empty() && angle - planes.horizontal.back() < same_angle) continue;
    planes.horizontal.push_back(angle);
  }
  planes.horizontal.back() = 360.0;
  for (const auto h : planes.horizontal)
    for (const auto v : distribution.vertical())
      planes.candela.push_back(distribution.at_angles(v, (h == 360.0 ? 0.0 : h) - turn));
  return planes;
}

std::string turn_luminaire(Photometry& photometry, double turn) {
  const auto [quarter, is_exact] = quarters(turn);
  auto& intensity = photometry.intensity;
  if (intensity.type() != GoniometerType::c) {
    if (!is_exact)
      throw InputError(fmt::format(
          "expected a turn by a multiple of 90 degrees for photometry of type A or B, found {:g}", turn));
    for (int i = 0; i < quarter; ++i) intensity = quarter_turned(intensity);
  } else if (intensity.horizontal().size() > 1 && !(is_exact && quarter == 0)) {
    auto planes = all_around(intensity, turn);
    intensity = {GoniometerType::c, intensity.vertical(), std::move(planes.horizontal),
                 std::move(planes.candela)};
  }
  turn_opening(photometry.opening, quarter);
  const auto& size = photometry.opening.size;
  if (is_exact || photometry.opening.shape == OpeningShape::point ||
      (size.x == size.y && (photometry.opening.shape == OpeningShape::ellipse ||
                            photometry.opening.shape == OpeningShape::vertical_cylinder ||
                            photometry.opening.shape == OpeningShape::ellipsoid)))
    return {};
  return fmt::format(
      "the luminous opening is turned by {} degrees only, the nearest quarter turn to {:g}; turn the "
      "luminaire in "
      "the scene instead",
      90 * quarter, turn);
}

}  // namespace luxel
