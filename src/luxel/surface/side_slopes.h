// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/patch/patch_set.h"
#include "luxel/patch/side.h"
#include "luxel/surface/side_light.h"
#include "luxel/surface/side_nodes.h"

namespace luxel {

// The irradiance over each patch side as a linear function of the place whose mean is the side's own value.
//
// The slope is that of the plane through the side's value that comes nearest to the values of all sides it
// shares a node with, each taken at its centroid (the mean of a linear function is its value there), by least
// squares with weights of one over distance squared. Centroids off the plane are turned into it at their
// distance, so that a bent sheet counts as unrolled. Smaller sides in another plane count by their size:
// light steps at the bevels of a flat face. No slope where the neighbours stand on one line.
//
// A corner is then held between the least and the greatest of those values (Barth and Jespersen 1989), and
// exceeds them only by what the plane adds beyond all the centroids: in full where the plane explains all the
// neighbours have, not at all where it explains three quarters of their squares or less, and the less the
// fewer they are. Linear light is thus unchanged at a border too, a step or mere noise is not extrapolated
// there, and inside a surface, where centroids stand all around, no corner is beyond the values nearby.
//
// Cost: about a microsecond per side on one thread.
class SideSlopes {
 public:
  SideSlopes(const PatchSet& patches, const SideLight& light, const SideNodes& nodes, const Context& context);

  // Value at a corner (0 to 2) minus the mean, W/m².
  double rise(SideId side, std::uint32_t corner, std::size_t band) const {
    return static_cast<double>(rise_[3 * (side.index() * bands_ + band) + corner]);
  }

 private:
  std::size_t bands_;
  std::vector<float> rise_;  // [side][band][corner]
};

}  // namespace luxel
