// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "luxel/core/vector.h"

namespace luxel {

// Numbered points in cubic cells, found by the cells of a box. Thread-safe once made.
class PointCells {
 public:
  struct Point {
    Vec3d place;
    std::uint32_t number;
  };

  // size: the width of a cell, above 0, in the unit of the places.
  PointCells(const std::vector<Point>& points, double size) : size_(size) {
    entries_.reserve(points.size());
    for (const auto& p : points) entries_.push_back({cell_of(p.place), p.number});
    std::sort(entries_.begin(), entries_.end());
  }

  // Calls body(number) for each point in the cells that the box touches: all in the box, and some around it.
  template <typename Body>
  void for_each_in(const Vec3d& low, const Vec3d& high, Body body) const {
    const auto a = cell_of(low), b = cell_of(high);
    for (auto x = a[0]; x <= b[0]; ++x)
      for (auto y = a[1]; y <= b[1]; ++y) {
        const Cell first{x, y, a[2]};
        for (auto e = std::lower_bound(entries_.begin(), entries_.end(), Entry{first, 0});
             e != entries_.end() && e->first <= Cell{x, y, b[2]}; ++e)
          body(e->second);
      }
  }

 private:
  using Cell = std::array<std::int64_t, 3>;
  using Entry = std::pair<Cell, std::uint32_t>;

  Cell cell_of(const Vec3d& p) const {
    const auto index = [this](double x) { return static_cast<std::int64_t>(std::floor(x / size_)); };
    return {index(p.x), index(p.y), index(p.z)};
  }

  double size_;
  std::vector<Entry> entries_;
};

}  // namespace luxel
