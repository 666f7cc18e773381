// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "luxel/core/vector.h"

namespace luxel {

// Points of a measurement, in the coordinates of the scene's file.
struct PointList {
  std::vector<Vec3d> position;  // m
  std::vector<Vec3d> normal;    // unit
  std::size_t columns = 0;      // of a grid, whose points are listed row by row; 0: no grid

  void add(const Vec3d& at, const Vec3d& towards) {
    position.push_back(at);
    normal.push_back(towards);
  }
};

inline constexpr std::size_t max_points = 10'000'000;

// Reads points from a CSV file: x,y,z or x,y,z,nx,ny,nz on each line, m. A first line with names may select
// the columns, in any order and among others. Points without a normal get `normal`. Empty lines and lines
// that begin with # are ignored. Throws InputError with file and line.
PointList read_points(const std::string& file, const Vec3d& normal);

// "x,y,z:x,y,z:N": N points from one end to the other, ends included.
struct PointLine {
  Vec3d from{0.0}, to{0.0};
  std::size_t count = 2;
};
std::optional<PointLine> parse_line(const std::string& text);
PointList points_of(const PointLine& line, const Vec3d& normal);

// "x,y,z:x,y,z:x,y,z:NxM": the parallelogram of a corner and its two neighbours, N cells towards the first of
// these and M towards the second. A point is in the middle of each cell.
struct PointGrid {
  Vec3d corner{0.0}, first{0.0}, second{0.0};
  std::size_t columns = 1, rows = 1;
};
std::optional<PointGrid> parse_grid(const std::string& text);
// normal: of all points; nothing: that of the grid, by the right-hand rule from its first to its second edge.
PointList points_of(const PointGrid& grid, const std::optional<Vec3d>& normal);

}  // namespace luxel
