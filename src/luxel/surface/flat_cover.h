// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "luxel/core/bounds.h"
#include "luxel/core/none.h"
#include "luxel/core/vector.h"

namespace luxel {

// Triangles in a plane, none over another, found by place: a grid with about one per cell.
class FlatCover {
 public:
  using Triangle = std::array<glm::dvec2, 3>;  // counter-clockwise

  // low, high: of the box around them all; count: how many are to come.
  FlatCover(const glm::dvec2& low, const glm::dvec2& high, std::size_t count);

  // Adds a triangle unless it covers another. Overlaps below a hundred-thousandth of the box are rounding.
  bool add(const Triangle& t);
  // Adds a triangle that is known to cover none.
  void put(const Triangle& t);
  // Returns the triangle at a place, counted in the order of adding; or none.
  std::uint32_t at(const glm::dvec2& place) const;

 private:
  std::size_t cell_of(double x) const;
  template <typename Body>
  void for_cells(const Box<glm::dvec2>& box, const Body& body);
  void put(const Triangle& t, const Box<glm::dvec2>& box);
  static Box<glm::dvec2> box_of(const Triangle& t);

  glm::dvec2 low_;
  double tolerance_ = 0.0, cell_ = 1.0;
  std::size_t width_ = 1, height_ = 1;  // in cells
  std::vector<std::vector<std::uint32_t>> cells_;
  std::vector<Triangle> triangles_;
  std::vector<Box<glm::dvec2>> boxes_;  // of the triangles
};

}  // namespace luxel
