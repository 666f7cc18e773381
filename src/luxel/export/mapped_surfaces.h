// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "luxel/export/round_trip_surfaces.h"
#include "luxel/surface/pack_charts.h"

namespace luxel {

// Which of a scene's triangles are cut for the pages of a lightmap: those that the charts part, on either
// side; for what is written of front and back shall lie on each other exactly, or they would fight where the
// file is read again.
class PageCuts {
 public:
  PageCuts(const RoundTripScene& round_trip, const Atlas& atlas);
  bool is_cut(std::size_t triangle) const { return is_cut_[triangle]; }  // into its patches
  // Whether a vertex of the patches is a corner of what is drawn there: neighbours that are not cut take it
  // too, or a crack would show between them.
  bool is_drawn(std::uint32_t point) const { return is_drawn_[point]; }

 private:
  std::vector<bool> is_cut_;    // [triangle]
  std::vector<bool> is_drawn_;  // [vertex of the patches]
};

// The file's own triangles where a chart has the whole of one, else patches; a surface for each page.
std::vector<RoundTripSurface> mapped_surfaces(const RoundTripScene& round_trip, const RoundTripPart& part,
                                              const Atlas& atlas, const PageCuts& cuts);

}  // namespace luxel
