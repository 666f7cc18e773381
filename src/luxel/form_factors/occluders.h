// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "luxel/core/vector.h"
#include "luxel/patch/patch_set.h"

namespace luxel {

// Flat convex polygons that together cover what the patches cover: a wall that is cut into a thousand patches
// hides no more than the wall, and is clipped against once. Patches are joined across shared edges, in one
// plane, as long as the union stays convex. Read-only after construction.
class Occluders {
 public:
  // slack, m: how far a polygon may depart from its patches. 20 us per patch.
  Occluders(const PatchSet& patches, double slack);

  std::size_t size() const { return begin_.size() - 1; }
  // m, counter-clockwise about either normal; at least three corners, at most 16.
  std::span<const Vec3d> polygon(std::size_t k) const {
    return std::span(corners_).subspan(begin_[k], begin_[k + 1] - begin_[k]);
  }

 private:
  std::vector<Vec3d> corners_;
  std::vector<std::uint32_t> begin_;  // [polygon]: its first corner; one more at the end
};

}  // namespace luxel
