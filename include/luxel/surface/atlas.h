// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "luxel/core/none.h"
#include "luxel/core/vector.h"
#include "luxel/patch/side.h"

namespace luxel {

/// Position of each side of each patch on the pages of a lightmap. Pages are square; texel (x, y), counted
/// from the top left, has its middle at (x + 0.5, y + 0.5).
struct Atlas {
  struct Place {  ///< of a chart
    std::uint32_t page = 0;
    int x = 0, y = 0, width = 1, height = 1;  ///< texels
  };
  int page_size = 0;  ///< texels, a power of two where less than asked for was enough
  int pages = 0;
  int margin = 0;
  std::vector<Place> places;                 ///< [chart]
  std::vector<std::uint32_t> chart_of;       ///< [side], or none: no light is kept of it
  std::vector<std::array<Vec2, 3>> corners;  ///< [side][corner of the patch]: texels on its page

  bool has(SideId side) const { return chart_of[side.index()] != none; }
  std::uint32_t page_of(SideId side) const { return places[chart_of[side.index()]].page; }
  /// UV in [0, 1] from the top left, as in glTF. Corners 0 to 2 as in PatchSet::corners, of backs too.
  Vec2 uv(SideId side, std::size_t corner) const {
    return corners[side.index()][corner] / static_cast<float>(page_size);
  }
};

}  // namespace luxel
