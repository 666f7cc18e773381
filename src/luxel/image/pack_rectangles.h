// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

namespace luxel {

struct Rectangle {
  int width = 0, height = 0;   // pixels, at least 1
  int page = 0, x = 0, y = 0;  // where it was put, from the top left
};

// Packs rectangles on square pages without overlap, on as many pages as needed, each filled by the skyline
// method (Jylanki 2010). Returns the number of pages. No rectangle may be larger than the page, which is up
// to 16384 pixels wide. The same input gives the same layout.
int pack_rectangles(std::span<Rectangle> rectangles, int page_size);

}  // namespace luxel
