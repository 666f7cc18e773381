// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

namespace luxel {

struct Rectangle {
  int width = 0, height = 0;   // pixels, at least 1
  int page = 0, x = 0, y = 0;  // where it was put, from the top left
};

// Puts rectangles on square pages, none over another; as many pages as it takes, each filled as far as the
// skyline method goes (Jylanki 2010). Returns the number of pages. None may be larger than the page, which is
// up to 16384 pixels wide. The same input gives the same places.
int pack_rectangles(std::span<Rectangle> rectangles, int page_size);

}  // namespace luxel
