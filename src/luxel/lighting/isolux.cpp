// SPDX-License-Identifier: Apache-2.0
#include "luxel/lighting/isolux.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>

namespace luxel {
namespace {

constexpr std::size_t subdivision = 8;  // of a cell between four points, per side

// A point where a line crosses an edge of the fine lattice: the edge's lower node, and whether it goes up.
struct Crossing {
  std::uint64_t edge = 0;
  Vec2d at{0.0};
};

// The cubic of Catmull and Rom through b and c, s in [0, 1]; a and d are their outer neighbours.
double cubic(double a, double b, double c, double d, double s) {
  const auto slope_b = 0.5 * (c - a), slope_c = 0.5 * (d - b);
  return b + s * (slope_b +
                  s * (3.0 * (c - b) - 2.0 * slope_b - slope_c + s * (2.0 * (b - c) + slope_b + slope_c)));
}

// The values of a grid with one more cell on each side. Cells without a point have values where they are
// needed as neighbours: the mean of the straight lines through the two points beside them.
class PaddedValues {
 public:
  PaddedValues(const CalculationGrid& grid, const std::vector<double>& values)
      : columns_(grid.columns + 2), rows_(grid.rows + 2), v_(columns_ * rows_, missing) {
    for (std::size_t i = 0; i < values.size(); ++i)
      v_[(grid.cell[i] / grid.columns + 1) * columns_ + grid.cell[i] % grid.columns + 1] = values[i];
    fill();
    fill();  // corners, from what the first pass filled
  }

  // The smooth interpolant in the square of four points whose lowest one is in cell (i, j) of the grid; s and
  // t in [0, 1].
  double at(std::size_t i, std::size_t j, double s, double t) const {
    std::array<double, 4> row{};
    for (std::size_t k = 0; k < 4; ++k) {
      const auto* v = &v_[(j + k) * columns_ + i];
      row[k] = cubic(v[0], v[1], v[2], v[3], s);
    }
    return cubic(row[0], row[1], row[2], row[3], t);
  }

 private:
  static constexpr double missing = std::numeric_limits<double>::quiet_NaN();

  double value(std::ptrdiff_t x, std::ptrdiff_t y) const {
    if (x < 0 || y < 0 || x >= static_cast<std::ptrdiff_t>(columns_) ||
        y >= static_cast<std::ptrdiff_t>(rows_))
      return missing;
    return v_[static_cast<std::size_t>(y) * columns_ + static_cast<std::size_t>(x)];
  }

  double extended(std::ptrdiff_t x, std::ptrdiff_t y) const {
    double lines = 0.0, nearest = 0.0;
    int line_count = 0, count = 0;
    for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
      const auto one = value(x + dx, y + dy), two = value(x + 2 * dx, y + 2 * dy);
      if (std::isnan(one)) continue;
      nearest += one;
      ++count;
      if (std::isnan(two)) continue;
      lines += 2.0 * one - two;
      ++line_count;
    }
    return line_count > 0 ? lines / line_count : count > 0 ? nearest / count : missing;
  }

  void fill() {
    auto filled = v_;
    for (std::size_t y = 0; y < rows_; ++y)
      for (std::size_t x = 0; x < columns_; ++x)
        if (auto& v = filled[y * columns_ + x]; std::isnan(v))
          v = extended(static_cast<std::ptrdiff_t>(x), static_cast<std::ptrdiff_t>(y));
    v_ = std::move(filled);
  }

  std::size_t columns_, rows_;
  std::vector<double> v_;
};

class Marcher {
 public:
  Marcher(const CalculationGrid& grid, const std::vector<double>& values)
      : grid_(grid), values_(grid, values), point_(grid.point_of_cells()) {}

  std::vector<IsoluxLine> lines(double level) {
    level_ = level;
    next_.clear();
    at_.clear();
    for (std::size_t j = 0; j + 1 < grid_.rows; ++j)
      for (std::size_t i = 0; i + 1 < grid_.columns; ++i) march(i, j);
    return joined();
  }

 private:
  void march(std::size_t i, std::size_t j) {
    for (std::size_t k = 0; k < 4; ++k)
      if (point_[(j + k / 2) * grid_.columns + i + k % 2] == none) return;
    for (std::size_t b = 0; b < subdivision; ++b)
      for (std::size_t a = 0; a < subdivision; ++a) march_fine(i, j, a, b);
  }

  // A node of the fine lattice over the whole grid.
  Vec2d place(std::size_t x, std::size_t y) const {
    const auto step = [](double side, std::size_t cells) {
      return side / static_cast<double>(cells * subdivision);
    };
    const auto half = 0.5 * static_cast<double>(subdivision);
    return {step(grid_.width, grid_.columns) * (static_cast<double>(x) + half),
            step(grid_.height, grid_.rows) * (static_cast<double>(y) + half)};
  }

  void march_fine(std::size_t i, std::size_t j, std::size_t a, std::size_t b) {
    const auto x = i * subdivision + a, y = j * subdivision + b;
    constexpr auto size = static_cast<double>(subdivision);
    const auto value = [&](std::size_t dx, std::size_t dy) {
      return values_.at(i, j, static_cast<double>(a + dx) / size, static_cast<double>(b + dy) / size);
    };
    const std::array<double, 4> v = {value(0, 0), value(1, 0), value(1, 1), value(0, 1)};
    constexpr std::array<std::array<std::size_t, 2>, 4> corner = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    std::vector<std::size_t> crossed;  // edges 0 to 3, each from its corner to the next
    for (std::size_t e = 0; e < 4; ++e)
      if ((v[e] < level_) != (v[(e + 1) % 4] < level_)) crossed.push_back(e);
    const auto crossing = [&](std::size_t e) {
      const auto f = (e + 1) % 4;
      const auto& p = corner[e];
      const auto& q = corner[f];
      const auto t = (level_ - v[e]) / (v[f] - v[e]);
      const auto lowest_x = x + std::min(p[0], q[0]), lowest_y = y + std::min(p[1], q[1]);
      const auto width = grid_.columns * subdivision + 1;
      Crossing c;
      c.edge = 2 * (lowest_y * width + lowest_x) + (p[0] == q[0] ? 1 : 0);
      c.at = (1.0 - t) * place(x + p[0], y + p[1]) + t * place(x + q[0], y + q[1]);
      return c;
    };
    if (crossed.size() == 2) return join(crossing(crossed[0]), crossing(crossed[1]));
    if (crossed.size() != 4) return;
    // A saddle: the value in the middle decides which corners belong together (asymptotic decider).
    const bool middle_is_low = 0.25 * (v[0] + v[1] + v[2] + v[3]) < level_;
    const bool first_is_cut_off = (v[0] < level_) != middle_is_low;
    join(crossing(0), crossing(first_is_cut_off ? 3 : 1));
    join(crossing(2), crossing(first_is_cut_off ? 1 : 3));
  }

  void join(const Crossing& p, const Crossing& q) {
    at_[p.edge] = p.at;
    at_[q.edge] = q.at;
    next_[p.edge].push_back(q.edge);
    next_[q.edge].push_back(p.edge);
  }

  std::vector<IsoluxLine> joined() {
    std::vector<IsoluxLine> lines;
    for (const bool from_ends : {true, false})  // open lines first, then closed ones
      for (auto& [edge, others] : next_)
        if (others.size() == 1 || (!from_ends && !others.empty())) lines.push_back(walk(edge));
    return lines;
  }

  IsoluxLine walk(std::uint64_t edge) {
    IsoluxLine line{level_, {at_[edge]}, false};
    const auto first = edge;
    while (!next_[edge].empty()) {
      const auto other = next_[edge].back();
      next_[edge].pop_back();
      auto& back = next_[other];
      back.erase(std::find(back.begin(), back.end(), edge));
      line.points.push_back(at_[other]);
      edge = other;
    }
    line.is_closed = edge == first;
    return line;
  }

  const CalculationGrid& grid_;
  PaddedValues values_;
  std::vector<std::uint32_t> point_;
  double level_ = 0.0;
  std::map<std::uint64_t, std::vector<std::uint64_t>> next_;
  std::map<std::uint64_t, Vec2d> at_;
};

}  // namespace

std::vector<double> isolux_levels(double low, double high) {
  if (!(low < high) || !std::isfinite(high)) return {};
  constexpr std::size_t min_levels = 4, max_levels = 12;
  std::vector<double> levels;
  const auto first_power = std::floor(std::log10(std::max(low, 1e-3 * high)));
  for (auto power = std::pow(10.0, first_power); power < high; power *= 10.0)
    for (const double step : {1.0, 1.5, 2.0, 3.0, 5.0, 7.5})
      if (step * power > low && step * power < high) levels.push_back(step * power);
  if (levels.size() >= min_levels && levels.size() <= max_levels) return levels;
  const auto rough = (high - low) / 8.0;
  const auto power = std::pow(10.0, std::floor(std::log10(rough)));
  double step = 10.0 * power;
  for (const double factor : {5.0, 2.0, 1.0})
    if (factor * power >= rough) step = factor * power;
  levels.clear();
  for (auto k = std::floor(low / step) + 1.0; k * step < high; k += 1.0) levels.push_back(k * step);
  return levels;
}

std::vector<IsoluxLine> isolux_lines(const CalculationGrid& grid, const std::vector<double>& values,
                                     const std::vector<double>& levels) {
  Marcher marcher(grid, values);
  std::vector<IsoluxLine> all;
  for (const auto level : levels)
    for (auto& line : marcher.lines(level)) all.push_back(std::move(line));
  return all;
}

}  // namespace luxel
