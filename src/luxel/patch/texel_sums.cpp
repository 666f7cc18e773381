// SPDX-License-Identifier: Apache-2.0
#include "luxel/patch/texel_sums.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace luxel {
namespace {

constexpr std::int64_t block = 8;       // pixels; 4 bytes per pixel for the table, 4 look-ups per sum
constexpr std::size_t rows_grain = 16;  // rows of a table that a thread takes at a time
constexpr double most_repeats = 24.0;   // of the picture, along a side of a triangle
constexpr double farthest_place = 1e9;  // in repeats; beyond, floats know no pixels
constexpr int samples_along = 256;

std::int64_t floored(double x) {
  const auto whole = static_cast<std::int64_t>(x);
  return whole - (static_cast<double>(whole) > x ? 1 : 0);
}

struct Range {
  double low, high;
  double size() const { return high - low; }
  double reach() const { return std::fabs(low) + std::fabs(high) + 1.0; }
};
Range extent(const std::array<glm::dvec2, 3>& t, int axis) {
  const auto [low, high] = std::minmax({t[0][axis], t[1][axis], t[2][axis]});
  return {low, high};
}

}  // namespace

TexelSums::TexelSums(std::shared_ptr<const Raster> raster, std::array<Wrap, 2> wrap,
                     std::optional<float> threshold, const Workers& workers)
    : raster_(std::move(raster)),
      wrap_(wrap),
      threshold_(threshold),
      blocks_(static_cast<std::size_t>(raster_->width / block + 1)) {
  const auto height = static_cast<std::size_t>(raster_->height);
  const auto width = static_cast<std::size_t>(raster_->width);
  before_.resize(height * (blocks_ + 1));
  std::vector<Vec3d> plain(height, Vec3d(0.0));  // with the colours of holes
  workers.for_chunks(height, rows_grain, [&](std::size_t begin, std::size_t end, int) {
    for (auto y = begin; y < end; ++y) {
      const auto table = std::span(before_).subspan(y * (blocks_ + 1), blocks_ + 1);
      Sum sum(0.0);
      for (std::size_t x = 0; x < width; ++x) {
        if (x % block == 0) table[x / block] = sum;
        sum += value(y * width + x);
        plain[y] += Vec3d(raster_->colour(y * width + x));
      }
      std::fill(table.begin() + static_cast<std::ptrdiff_t>((width - 1) / block + 1), table.end(), sum);
    }
  });
  Sum all(0.0);
  Vec3d all_plain(0.0);
  for (std::size_t y = 0; y < height; ++y) {
    all += before_[(y + 1) * (blocks_ + 1) - 1];
    all_plain += plain[y];
  }
  const auto area = static_cast<double>(width * height);
  whole_ = mean_of(all, area, {Vec3(all_plain / area), 0.0f});
}

TexelSums::Sum TexelSums::value(std::size_t index) const {
  if (threshold_ && raster_->alpha(index) < *threshold_) return Sum(0.0);
  return {Vec3d(raster_->colour(index)), 1.0};
}

// row: of the picture; x: any.
TexelSums::Sum TexelSums::pixel(std::int64_t x, std::int64_t row) const {
  const std::int64_t width = raster_->width;
  if (x < 0 || x >= width) x = wrapped(x, width, wrap_[0]);
  return value(static_cast<std::size_t>(row * width + x));
}

// Sum of the row's pixels from column 0 to before x, from 0 to the width.
TexelSums::Sum TexelSums::before_within(std::int64_t x, std::int64_t row) const {
  auto sum = before_[static_cast<std::size_t>(row) * (blocks_ + 1) + static_cast<std::size_t>(x / block)];
  const auto first = static_cast<std::size_t>(row * raster_->width);
  for (auto i = x / block * block; i < x; ++i) sum += value(first + static_cast<std::size_t>(i));
  return sum;
}

// Likewise for any x; negative sums left of column 0.
TexelSums::Sum TexelSums::before(std::int64_t x, std::int64_t row) const {
  const std::int64_t width = raster_->width;
  if (x >= 0 && x <= width) return before_within(x, row);
  if (wrap_[0] == Wrap::clamp) {
    const auto inside = x < 0 ? std::int64_t{0} : width;
    return before_within(inside, row) + static_cast<double>(x - inside) * pixel(x, row);
  }
  const auto all = before_within(width, row);
  const auto periods = x >= 0 ? x / width : -((-x + width - 1) / width);
  const auto rest = x - periods * width;
  const bool is_mirrored = wrap_[0] == Wrap::mirror && periods % 2 != 0;
  const auto last = is_mirrored ? all - before_within(width - rest, row) : before_within(rest, row);
  return last + static_cast<double>(periods) * all;
}

// The mean of before(x), linear between pixels, over x between two places.
TexelSums::Sum TexelSums::mean_before(double from, double to, std::int64_t row) const {
  const auto [left, right] = std::minmax(from, to);
  auto column = floored(left);
  auto start = before(column, row);
  auto slope = pixel(column, row);
  const auto until = [&](double l, double r) {
    return start + (0.5 * (l + r) - static_cast<double>(column)) * slope;
  };
  auto border = static_cast<double>(column + 1);
  if (right <= border) return until(left, right);
  auto sum = (border - left) * until(left, border);
  for (;;) {
    start += slope;
    slope = pixel(++column, row);
    border = static_cast<double>(column + 1);
    if (right <= border) break;
    sum += until(border - 1.0, border);
  }
  sum += (right - (border - 1.0)) * until(border - 1.0, right);
  return sum / (right - left);
}

// The integral of before(x) over y, along an edge; the same but for its sign the other way.
TexelSums::Sum TexelSums::along_edge(const Point& a, const Point& b) const {
  const bool is_down = a.y < b.y;
  const auto& top = is_down ? a : b;
  const auto& bottom = is_down ? b : a;
  const auto slope = (bottom.x - top.x) / (bottom.y - top.y);
  Sum sum(0.0);
  auto from = top;
  for (auto y = floored(top.y); from.y < bottom.y; ++y) {
    const auto end = static_cast<double>(y + 1);
    const auto to = end < bottom.y ? Point(top.x + slope * (end - top.y), end) : bottom;
    sum += (to.y - from.y) * mean_before(from.x, to.x, row_of(y));
    from = to;
  }
  return is_down ? sum : -sum;
}

TexelSums::Sum TexelSums::along_side(const Triangle& t) const {
  const auto length = [&](std::size_t i) { return glm::distance(t[i], t[(i + 1) % 3]); };
  std::size_t longest = 0;
  for (const std::size_t i : {1, 2})
    if (length(i) > length(longest)) longest = i;
  const auto from = t[longest], to = t[(longest + 1) % 3];
  Sum sum(0.0);
  for (int i = 0; i < samples_along; ++i) {
    const auto place = from + (i + 0.5) / samples_along * (to - from);
    sum += pixel(floored(place.x), row_of(floored(place.y)));
  }
  return sum;
}

TexelSums::Mean TexelSums::mean_of(const Sum& sum, double area, const Mean& otherwise) {
  if (!(sum.w > 0.0)) return {otherwise.colour, 0.0f};
  return {glm::max(Vec3(Vec3d(sum) / sum.w), Vec3(0.0f)),
          static_cast<float>(std::clamp(sum.w / area, 0.0, 1.0))};
}

TexelSums::Mean TexelSums::over(const std::array<Vec2, 3>& places) const {
  const Point size(raster_->width, raster_->height);
  Triangle t;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!(std::fabs(places[k].x) < farthest_place && std::fabs(places[k].y) < farthest_place)) return whole_;
    t[k] = Point(places[k]) * size;
  }
  const auto columns = extent(t, 0), rows = extent(t, 1);
  if (columns.size() > most_repeats * size.x || rows.size() > most_repeats * size.y) return whole_;
  // Nearer the first column, sums are shorter.
  if (wrap_[0] != Wrap::clamp) {
    const auto period = wrap_[0] == Wrap::mirror ? 2.0 * size.x : size.x;
    for (auto& p : t) p.x -= std::floor(columns.low / period) * period;
  }
  const auto ab = t[1] - t[0], ac = t[2] - t[0];
  const auto area = 0.5 * (ab.x * ac.y - ab.y * ac.x);
  // Of a sliver that floats cannot tell from a line, areas are mostly rounding.
  if (!(std::fabs(area) > 1e-12 * columns.reach() * rows.reach()))
    return mean_of(along_side(t), samples_along, whole_);
  const auto sum = along_edge(t[0], t[1]) + along_edge(t[1], t[2]) + along_edge(t[2], t[0]);
  return mean_of(area > 0.0 ? sum : -sum, std::fabs(area), whole_);
}

}  // namespace luxel
