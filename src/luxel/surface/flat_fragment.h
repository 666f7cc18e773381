// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "luxel/patch/patch_set.h"
#include "luxel/surface/make_charts.h"

namespace luxel {

// The way a side looks: its normal, unit.
inline Vec3d facing(const PatchSet& patches, std::uint32_t side) {
  const Vec3d n(patches.normal[side / 2]);
  return side % 2 == 0 ? n : -n;
}

// The sides as a chart, seen along `direction` (unit), which they all face: in the smallest of the boxes that
// have an edge along their convex hull (Freeman and Shapira 1975).
Chart flat_chart(const PatchSet& patches, std::vector<std::uint32_t> sides, const Vec3d& direction);

// Keeps those sides that cover none kept before, seen along `direction`; what is taken off is given back in
// the second list. Overlaps of less than a hundred-thousandth of the whole are rounding.
struct Placed {
  std::vector<std::uint32_t> kept, over;
};
Placed without_overlaps(const PatchSet& patches, std::span<const std::uint32_t> sides,
                        const Vec3d& direction);

}  // namespace luxel
