// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "luxel/core/vector.h"

namespace luxel {

// Twice the signed area of a triangle: positive where a, b, c turn to the left. From floats it is exact but
// for a last bit: their differences and products fit a double.
inline double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Ear clipping (Meisters, "Polygons have ears", 1975) with a grid over the corners, so that an ear is tested
// only against corners near it. For one polygon of at least three corners, counter-clockwise; `points` must
// outlive it.
class EarClipper {
 public:
  explicit EarClipper(std::span<const glm::dvec2> points);

  // Appends exactly points.size() - 2 triangles. Call it once.
  void clip(std::vector<std::array<std::uint32_t, 3>>& triangles);

 private:
  using Triangles = std::vector<std::array<std::uint32_t, 3>>;
  // The corners that may be cut off, by priority: ears; then corners without area; then, in a polygon that
  // crosses itself, a convex corner; finally any corner.
  enum class Demand { ear, flat, convex, none };

  void build_grid();
  std::size_t column(double x) const;
  std::size_t row(double y) const;
  std::size_t go_round(Demand demand, Triangles& triangles);
  void cut(std::uint32_t corner, Triangles& triangles);
  bool meets(std::uint32_t corner, Demand demand);
  bool is_ear(std::uint32_t corner);
  bool blocks(std::uint32_t other, std::uint32_t corner) const;
  bool leads_between(std::uint32_t other, const glm::dvec2& right, const glm::dvec2& left) const;
  double turn_at(std::uint32_t corner) const;

  std::span<const glm::dvec2> points_;
  std::vector<std::uint32_t> next_, previous_;  // the ring of corners not yet cut off
  std::vector<char> may_block_;                 // corners in the ring that are not strictly convex
  std::size_t left_;                            // corners in the ring
  bool are_ears_few_ = false;                   // in the last round
  std::uint32_t here_ = 0;                      // the corner looked at
  std::size_t work_ = 0;                        // corners and cells looked at so far
  // About a second for a hundred thousand corners. Reached only by polygons made to be slow; their remainder
  // becomes a fan.
  std::size_t max_work_;

  glm::dvec2 low_, cells_per_unit_;
  std::size_t side_ = 1;                   // cells along a side of the grid
  std::vector<std::uint32_t> cell_begin_;  // side_ * side_ + 1, into cell_corner_
  std::vector<std::uint32_t> cell_corner_;
};

}  // namespace luxel
