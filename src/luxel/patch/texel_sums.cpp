// SPDX-License-Identifier: Apache-2.0
#include "luxel/patch/texel_sums.h"

#include <algorithm>
#include <cmath>

namespace luxel {
namespace {

constexpr std::int64_t block = 32;      // pixels
constexpr double most_repeats = 24.0;   // of the picture, along a side of a triangle
constexpr double farthest_place = 1e9;  // in repeats; beyond, floats know no pixels
constexpr int samples_along = 256;

using Polygon = std::vector<std::array<double, 2>>;

// The part of a convex polygon where sign * p[axis] >= sign * at.
Polygon clipped(const Polygon& polygon, std::size_t axis, double at, double sign) {
  Polygon part;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto& a = polygon[i];
    const auto& b = polygon[(i + 1) % polygon.size()];
    const auto from = sign * (a[axis] - at), to = sign * (b[axis] - at);
    if (from >= 0.0) part.push_back(a);
    if ((from > 0.0 && to < 0.0) || (from < 0.0 && to > 0.0)) {
      const auto t = from / (from - to);
      std::array<double, 2> crossing;
      crossing[axis] = at;
      crossing[1 - axis] = a[1 - axis] + t * (b[1 - axis] - a[1 - axis]);
      part.push_back(crossing);
    }
  }
  return part;
}

Polygon between(const Polygon& polygon, std::size_t axis, double low, double high) {
  return clipped(clipped(polygon, axis, low, 1.0), axis, high, -1.0);
}

double area_of(const Polygon& polygon) {
  double twice = 0.0;
  for (std::size_t i = 2; i < polygon.size(); ++i)
    twice += (polygon[i - 1][0] - polygon[0][0]) * (polygon[i][1] - polygon[0][1]) -
             (polygon[i][0] - polygon[0][0]) * (polygon[i - 1][1] - polygon[0][1]);
  return 0.5 * std::fabs(twice);
}

struct Range {
  double low, high;
};
Range extent(const Polygon& polygon, std::size_t axis) {
  const auto by_axis = [&](const auto& a, const auto& b) { return a[axis] < b[axis]; };
  const auto [low, high] = std::minmax_element(polygon.begin(), polygon.end(), by_axis);
  return {(*low)[axis], (*high)[axis]};
}

// Where a polygon that was cut to a row touches the row's border at y: from the lowest to the highest x.
std::optional<Range> on_border(const Polygon& part, double y) {
  std::optional<Range> found;
  for (const auto& p : part) {
    if (p[1] != y) continue;
    if (!found) found = Range{p[0], p[0]};
    found->low = std::min(found->low, p[0]);
    found->high = std::max(found->high, p[0]);
  }
  return found;
}

template <typename Sum>
Sum combined(const Sum& a, double factor, const Sum& b) {
  return {a.colour + factor * b.colour, a.covered + factor * b.covered, a.area + factor * b.area};
}

std::int64_t floored(double x) { return static_cast<std::int64_t>(std::floor(x)); }

}  // namespace

TexelSums::TexelSums(std::shared_ptr<const Raster> raster, std::array<Wrap, 2> wrap,
                     std::optional<float> threshold)
    : raster_(std::move(raster)),
      wrap_(wrap),
      threshold_(threshold),
      blocks_(static_cast<std::size_t>(raster_->width / block + 1)) {
  const auto height = static_cast<std::size_t>(raster_->height);
  before_.reserve(height * (blocks_ + 1));
  Sum all;
  Vec3d plain(0.0);
  for (std::size_t y = 0; y < height; ++y) {
    Sum row;
    for (std::int64_t x = 0; x < raster_->width; ++x) {
      if (x % block == 0) before_.push_back(row);
      row = combined(row, 1.0, pixel(x, static_cast<std::int64_t>(y)));
      plain += Vec3d(raster_->colour(raster_->index(static_cast<int>(x), static_cast<int>(y))));
    }
    while (before_.size() < (y + 1) * (blocks_ + 1)) before_.push_back(row);
    all = combined(all, 1.0, row);
  }
  whole_ = mean_of(all, {Vec3(plain / all.area), 0.0f});
}

TexelSums::Sum TexelSums::pixel(std::int64_t x, std::int64_t y) const {
  const auto index = raster_->index(static_cast<int>(wrapped(x, raster_->width, wrap_[0])),
                                    static_cast<int>(wrapped(y, raster_->height, wrap_[1])));
  if (threshold_ && raster_->alpha(index) < *threshold_) return {Vec3d(0.0), 0.0, 1.0};
  return {Vec3d(raster_->colour(index)), 1.0, 1.0};
}

// x: from 0 to the width.
TexelSums::Sum TexelSums::within(std::size_t row, std::int64_t x) const {
  auto sum = before_[row * (blocks_ + 1) + static_cast<std::size_t>(x / block)];
  for (auto i = x / block * block; i < x; ++i)
    sum = combined(sum, 1.0, pixel(i, static_cast<std::int64_t>(row)));
  return sum;
}

TexelSums::Sum TexelSums::run(std::int64_t row, std::int64_t x) const {
  const auto y = static_cast<std::size_t>(wrapped(row, raster_->height, wrap_[1]));
  const std::int64_t width = raster_->width;
  const auto all = within(y, width);
  if (wrap_[0] == Wrap::clamp) {
    const auto inside = std::clamp<std::int64_t>(x, 0, width);
    return combined(within(y, inside), static_cast<double>(x - inside), pixel(x < 0 ? 0 : width - 1, row));
  }
  const auto periods = x >= 0 ? x / width : -((-x + width - 1) / width);
  const auto rest = x - periods * width;
  const bool is_mirrored = wrap_[0] == Wrap::mirror && periods % 2 != 0;
  const auto last = is_mirrored ? combined(all, -1.0, within(y, width - rest)) : within(y, rest);
  return combined(last, static_cast<double>(periods), all);
}

// part: of the triangle, cut to the row.
TexelSums::Sum TexelSums::of_row(const Polygon& part, std::int64_t row) const {
  Sum sum;
  const auto [left, right] = extent(part, 0);
  // Pixels from `first` to before `last` are covered from border to border.
  auto first = floored(right) + 1, last = first;
  const auto top = on_border(part, static_cast<double>(row));
  const auto bottom = on_border(part, static_cast<double>(row + 1));
  if (top && bottom) {
    const auto begin = static_cast<std::int64_t>(std::ceil(std::max(top->low, bottom->low)));
    const auto end = floored(std::min(top->high, bottom->high));
    if (begin < end) {
      first = begin;
      last = end;
      sum = combined(run(row, last), -1.0, run(row, first));
    }
  }
  for (auto x = floored(left); static_cast<double>(x) < right; ++x) {
    if (x == first && first < last) x = last;
    const auto inside = between(part, 0, static_cast<double>(x), static_cast<double>(x + 1));
    if (inside.size() > 2) sum = combined(sum, area_of(inside), pixel(x, row));
  }
  return sum;
}

TexelSums::Sum TexelSums::over_area(const Polygon& triangle) const {
  Sum sum;
  const auto [top, bottom] = extent(triangle, 1);
  auto rest = triangle;
  for (auto row = floored(top); static_cast<double>(row) < bottom; ++row) {
    const auto end = static_cast<double>(row + 1);
    const auto part = clipped(rest, 1, end, -1.0);
    if (part.size() > 2) sum = combined(sum, 1.0, of_row(part, row));
    rest = clipped(rest, 1, end, 1.0);
    if (rest.size() < 3) break;
  }
  return sum;
}

TexelSums::Sum TexelSums::along(const Polygon& triangle) const {
  std::array<double, 2> from{}, to{};
  double longest = -1.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& a = triangle[i];
    const auto& b = triangle[(i + 1) % 3];
    const auto length = std::hypot(b[0] - a[0], b[1] - a[1]);
    if (length <= longest) continue;
    longest = length;
    from = a;
    to = b;
  }
  Sum sum;
  for (int i = 0; i < samples_along; ++i) {
    const auto t = (i + 0.5) / samples_along;
    sum = combined(sum, 1.0,
                   pixel(floored(from[0] + t * (to[0] - from[0])), floored(from[1] + t * (to[1] - from[1]))));
  }
  return sum;
}

TexelSums::Mean TexelSums::mean_of(const Sum& sum, const Mean& otherwise) {
  if (!(sum.covered > 0.0)) return {otherwise.colour, 0.0f};
  return {glm::max(Vec3(sum.colour / sum.covered), Vec3(0.0f)),
          static_cast<float>(std::clamp(sum.covered / sum.area, 0.0, 1.0))};
}

TexelSums::Mean TexelSums::over(const std::array<Vec2, 3>& places) const {
  Polygon triangle;
  for (const auto& place : places) {
    if (!(std::fabs(place.x) < farthest_place && std::fabs(place.y) < farthest_place)) return whole_;
    triangle.push_back(
        {static_cast<double>(place.x) * raster_->width, static_cast<double>(place.y) * raster_->height});
  }
  const auto columns = extent(triangle, 0), rows = extent(triangle, 1);
  if (columns.high - columns.low > most_repeats * raster_->width ||
      rows.high - rows.low > most_repeats * raster_->height)
    return whole_;
  // Of a sliver that floats cannot tell from a line, areas are mostly rounding.
  const auto rounding = 1e-12 * (std::fabs(columns.low) + std::fabs(columns.high) + 1.0) *
                        (std::fabs(rows.low) + std::fabs(rows.high) + 1.0);
  return mean_of(area_of(triangle) > rounding ? over_area(triangle) : along(triangle), whole_);
}

}  // namespace luxel
