// SPDX-License-Identifier: Apache-2.0
#include "luxel/image/pack_rectangles.h"

#include <stb_rect_pack.h>

namespace luxel {

int pack_rectangles(std::span<Rectangle> rectangles, int page_size) {
  std::vector<stbrp_rect> left;
  for (std::size_t i = 0; i < rectangles.size(); ++i)
    left.push_back({static_cast<int>(i), rectangles[i].width, rectangles[i].height, 0, 0, 0});

  std::vector<stbrp_node> nodes(static_cast<std::size_t>(page_size));
  int pages = 0;
  for (; !left.empty(); ++pages) {
    stbrp_context context;
    stbrp_init_target(&context, page_size, page_size, nodes.data(), page_size);
    stbrp_pack_rects(&context, left.data(), static_cast<int>(left.size()));
    std::vector<stbrp_rect> over;
    for (const auto& r : left) {
      if (!r.was_packed) {
        over.push_back(r);
        continue;
      }
      auto& out = rectangles[static_cast<std::size_t>(r.id)];
      out.page = pages;
      out.x = r.x;
      out.y = r.y;
    }
    if (over.size() == left.size()) break;  // one that fits nowhere
    left = std::move(over);
  }
  return pages;
}

}  // namespace luxel
