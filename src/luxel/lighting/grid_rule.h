// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace luxel {

// The grid of EN 12464-1 for an area: cell size p = 0.2 * 5^log10(d) m, at most 10 m, where d is the longer
// side of the area, or the shorter one if the longer is at least twice as long.
struct GridRule {
  double spacing = 1.0;     // m, p
  std::size_t columns = 1;  // cells along the first side
  std::size_t rows = 1;     // cells along the second side
};

// first, second: sides of the area, m, above 0. Cells per side: side / p rounded to the nearest whole number,
// at least 1. Points of the grid are in the middle of the cells.
GridRule en12464_grid(double first, double second);

}  // namespace luxel
