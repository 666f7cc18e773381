// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "luxel/core/vector.h"
#include "luxel/patch/patch_set.h"
#include "luxel/surface/make_charts.h"

namespace luxel {

// Of all pages together: some 40 bytes each.
inline constexpr double max_texels_of_pages = 0x1p28;

struct PackOptions {
  float texel = 0.05f;   // m
  int page_size = 1024;  // texels, the most a page is wide and high; 8 to 16384
  int margin = 2;        // texels between charts, and at the edge of a page; 0 to 64
};

// Where each side of each patch lies on the pages of a lightmap. Pages are square; texel (x, y), counted from
// the top left, has its middle at (x + 0.5, y + 0.5).
struct Atlas {
  struct Place {  // of a chart
    std::uint32_t page = 0;
    int x = 0, y = 0, width = 1, height = 1;  // texels
  };
  int page_size = 0;  // texels, a power of two where less than asked for was enough
  int pages = 0;
  int margin = 0;
  std::vector<Place> places;                 // [chart]
  std::vector<std::uint32_t> chart_of;       // [side], or Charts::none: no light is kept of it
  std::vector<std::array<Vec2, 3>> corners;  // [side][corner of the patch]: texels on its page

  bool has(std::size_t side) const { return chart_of[side] != Charts::none; }
  std::uint32_t page_of(std::size_t side) const { return places[chart_of[side]].page; }
  // In [0, 1] from the top left, as glTF counts. Corner 0 to 2 as in PatchSet::corners, of backs too.
  Vec2 uv(std::size_t side, std::size_t corner) const {
    return corners[side][corner] / static_cast<float>(page_size);
  }
};

// Every chart gets the whole texels its box needs and is stretched to fill them, from the middle of the first
// to that of the last: so what is read between texels stays within the chart's own, and along straight
// borders lies right on them. At most `texel` is between two. The page is the smallest power of two that
// holds all charts, or page_size and as many of these as it takes.
//
// Throws what check_pack_options() does, with the margins counted too, and InputError where a chart fits on
// no page.
Atlas pack_charts(const PatchSet& patches, const Charts& charts, const PackOptions& options);

// Throws InputError where an option is out of its range, or the patches need more than 268 million texels.
void check_pack_options(const PatchSet& patches, const PackOptions& options);

// Texels that a chart may be wide so that it fits on a page, as in ChartOptions.
inline int max_texels(const PackOptions& options) { return options.page_size - 2 * options.margin - 1; }

}  // namespace luxel
