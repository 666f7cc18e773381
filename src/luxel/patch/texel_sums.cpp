// SPDX-License-Identifier: Apache-2.0
#include "luxel/patch/texel_sums.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace luxel {
namespace {

constexpr std::size_t rows_grain = 16;  // rows of a table per chunk of a thread
constexpr double max_repeats = 24.0;    // of the picture, along one side of a triangle
constexpr double farthest_place = 1e9;  // in repeats; beyond it floats do not resolve pixels
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
                     std::optional<float> threshold, const Context& context)
    : raster_(std::move(raster)), wrap_(wrap) {
  while (first_solid_ < 256 && threshold && static_cast<float>(first_solid_) / 255.0f < *threshold)
    ++first_solid_;
  if (raster_->codes.empty() && threshold) first_solid_ = 1.0f < *threshold ? 256 : 0;
  for (std::size_t code = 0; code < decoded_.size(); ++code)
    decoded_[code] = static_cast<double>(srgb_decode(static_cast<float>(code) / 255.0f));
  const auto height = static_cast<std::size_t>(raster_->height);
  const auto width = static_cast<std::size_t>(raster_->width);
  table_.resize((width / block + 1) * height);
  std::vector<Sum> all_of_row(height);
  std::vector<Vec3d> plain(height, Vec3d(0.0));  // including the colours of holes
  context.for_chunks(height, rows_grain, [&](std::size_t begin, std::size_t end, int) {
    for (auto y = begin; y < end; ++y) {
      Sum sum(0.0);
      for (std::size_t x = 0; x < width; ++x) {
        auto& here = table_[x / block * height + y];
        if (x % block == 0) here.before = sum;
        const auto pixel = y * width + x;
        if (!raster_->codes.empty()) here.codes[x % block] = raster_->codes[pixel];
        sum += raster_->codes.empty() ? value(raster_->linear[pixel]) : value(raster_->codes[pixel]);
        plain[y] += Vec3d(raster_->colour(pixel));
      }
      if (width % block == 0) table_[width / block * height + y].before = sum;
      all_of_row[y] = sum;
    }
  });
  const auto all = std::accumulate(all_of_row.begin(), all_of_row.end(), Sum(0.0));
  const auto all_plain = std::accumulate(plain.begin(), plain.end(), Vec3d(0.0));
  const auto area = static_cast<double>(width * height);
  whole_ = mean_of(all, area, {Vec3(all_plain / area), 0.0f});
}

TexelSums::Sum TexelSums::value(const Raster::Code& code) const {
  if (code[3] < first_solid_) return Sum(0.0);
  return {decoded_[code[0]], decoded_[code[1]], decoded_[code[2]], 1.0};
}

TexelSums::Sum TexelSums::value(const Vec3& colour) const {
  return first_solid_ > 255 ? Sum(0.0) : Sum(colour, 1.0);
}

// One row of the infinitely repeated picture.
class TexelSums::Row {
 public:
  Row(const TexelSums& sums, std::size_t row)
      : sums_(sums),
        width_(sums.raster_->width),
        table_(&sums.table_[row]),
        height_(sums.raster_->height),
        linear_(sums.raster_->codes.empty() ? &sums.raster_->linear[row * static_cast<std::size_t>(width_)]
                                            : nullptr) {}

  Sum pixel(std::int64_t x) const {
    return within(x >= 0 && x < width_ ? x : wrapped(x, width_, sums_.wrap_[0]));
  }

  // Sum of the pixels from column 0 to before x; negative sums left of column 0.
  Sum before(std::int64_t x) const {
    if (x >= 0 && x <= width_) return before_within(x);
    if (sums_.wrap_[0] == Wrap::clamp) {
      const auto inside = x < 0 ? std::int64_t{0} : width_;
      return before_within(inside) + static_cast<double>(x - inside) * pixel(x);
    }
    const auto all = before_within(width_);
    const auto periods = x >= 0 ? x / width_ : -((-x + width_ - 1) / width_);
    const auto rest = x - periods * width_;
    const bool is_mirrored = sums_.wrap_[0] == Wrap::mirror && periods % 2 != 0;
    const auto last = is_mirrored ? all - before_within(width_ - rest) : before_within(rest);
    return last + static_cast<double>(periods) * all;
  }

  // The mean of before(x), which is linear between pixels, over x between two places.
  Sum mean_before(double from, double to) const {
    const auto [left, right] = std::minmax(from, to);
    auto column = floored(left);
    auto start = before(column);
    auto slope = pixel(column);
    auto border = static_cast<double>(column + 1);
    const auto within = [&](double l, double r) { return start + (0.5 * (l + r) - (border - 1.0)) * slope; };
    if (right <= border) return within(left, right);
    auto sum = (border - left) * within(left, border);
    for (;;) {
      start += slope;
      slope = pixel(++column);
      border += 1.0;
      if (right <= border) break;
      sum += start + 0.5 * slope;
    }
    sum += (right - (border - 1.0)) * within(border - 1.0, right);
    return (1.0 / (right - left)) * sum;
  }

 private:
  const Block& block_of(std::int64_t x) const { return table_[x / block * height_]; }
  // x: column of the picture.
  Sum within(std::int64_t x) const {
    return linear_ ? sums_.value(linear_[x]) : sums_.value(block_of(x).codes[x % block]);
  }
  // x: 0 to the width.
  Sum before_within(std::int64_t x) const {
    auto sum = block_of(x).before;
    for (auto i = x / block * block; i < x; ++i) sum += within(i);
    return sum;
  }

  const TexelSums& sums_;
  std::int64_t width_;
  const Block* table_;
  std::int64_t height_;
  const Vec3* linear_;  // for rasters without codes
};

TexelSums::Row TexelSums::row_at(std::int64_t y) const {
  const std::int64_t height = raster_->height;
  return {*this, static_cast<std::size_t>(y >= 0 && y < height ? y : wrapped(y, height, wrap_[1]))};
}

// The integral of before(x) over y, along an edge; the opposite direction changes only its sign.
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
    sum += (to.y - from.y) * row_at(y).mean_before(from.x, to.x);
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
    sum += row_at(floored(place.y)).pixel(floored(place.x));
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
  if (columns.size() > max_repeats * size.x || rows.size() > max_repeats * size.y) return whole_;
  // Moved onto the picture itself where possible: sums are shorter and pixels are found without a division.
  const std::array extents = {columns, rows};
  for (int axis = 0; axis < 2; ++axis) {
    if (wrap_[static_cast<std::size_t>(axis)] == Wrap::clamp) continue;
    const auto period = wrap_[static_cast<std::size_t>(axis)] == Wrap::mirror ? 2.0 * size[axis] : size[axis];
    for (auto& p : t) p[axis] -= std::floor(extents[static_cast<std::size_t>(axis)].low / period) * period;
  }
  const auto ab = t[1] - t[0], ac = t[2] - t[0];
  const auto area = 0.5 * (ab.x * ac.y - ab.y * ac.x);
  // The area of a sliver that floats cannot distinguish from a line is mostly rounding.
  if (!(std::fabs(area) > 1e-12 * columns.reach() * rows.reach()))
    return mean_of(along_side(t), samples_along, whole_);
  const auto sum = along_edge(t[0], t[1]) + along_edge(t[1], t[2]) + along_edge(t[2], t[0]);
  return mean_of(area > 0.0 ? sum : -sum, std::fabs(area), whole_);
}

}  // namespace luxel
