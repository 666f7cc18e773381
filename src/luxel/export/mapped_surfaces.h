// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "luxel/export/round_trip_surfaces.h"
#include "luxel/surface/pack_charts.h"

namespace luxel {

// The triangles of a scene that are cut for the pages of a lightmap: those divided by charts on
// either side, since fronts and backs in the file must coincide exactly; otherwise they would
// conflict when it is read again.
class PageCuts {
 public:
  PageCuts(const RoundTripScene& round_trip, const Atlas& atlas);
  bool is_cut(std::size_t triangle) const { return is_cut_[triangle]; }  // into its patches
  // Returns whether a vertex of the patches is a corner of drawn triangles: uncut neighbours use it too,
  // since otherwise a crack would show between them.
  bool is_drawn(std::uint32_t point) const { return is_drawn_[point]; }

 private:
  std::vector<bool> is_cut_;    // [triangle]
  std::vector<bool> is_drawn_;  // [vertex of the patches]
};

// Returns the file's own triangles where one chart contains all of one, else patches; one surface per page.
std::vector<RoundTripSurface> mapped_surfaces(const RoundTripScene& round_trip, const RoundTripPart& part,
                                              const Atlas& atlas, const PageCuts& cuts);

}  // namespace luxel
