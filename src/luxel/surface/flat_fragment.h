// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "luxel/patch/patch_set.h"
#include "luxel/patch/side.h"
#include "luxel/surface/make_charts.h"

namespace luxel {

// The normal of a side, unit.
inline Vec3d facing(const PatchSet& patches, SideId side) { return Vec3d(patches.normal_of(side)); }

// The sides as a chart, seen along `direction` (unit), which they all face: in the smallest of the boxes that
// have an edge along their convex hull (Freeman and Shapira 1975).
Chart flat_chart(const PatchSet& patches, std::vector<SideId> sides, const Vec3d& direction);

// Keeps the sides that cover none kept before, seen along `direction`; the second list has the others.
// Overlaps of less than a hundred-thousandth of the whole are rounding.
struct Placed {
  std::vector<SideId> kept, over;
};
Placed without_overlaps(const PatchSet& patches, std::span<const SideId> sides, const Vec3d& direction);

}  // namespace luxel
