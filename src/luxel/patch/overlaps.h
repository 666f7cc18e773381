// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/core/vector.h"
#include "luxel/patch/patch_set.h"
#include "luxel/scene/clean_triangles.h"

namespace luxel {

// A triangle that lies in the plane of another one and overlaps it. Rays would meet either of the two, by
// the rounding of each; so only the cover has light where both are.
struct Overlap {
  std::uint32_t covered = 0, cover = 0;  // indices into CleanTriangles::kept
};

// Finds all overlaps, sorted by the covered triangle, then by the cover. Planes are the same within 16
// roundings of the coordinates. A lamp covers what is no lamp; otherwise the smaller surface covers the
// larger one: triangles that overlap, directly or in a chain, and have one material are a surface. Equal ones
// are ordered by material, area of the triangle and its number, so nothing covers what covers it.
//
// Not overlaps: two lamps; a cover with holes or that light passes; one-sided materials that face opposite
// ways, or a one-sided cover on a two-sided surface, as either is seen from a side of its own.
//
// material: of each triangle. Cost: 0.5 us per triangle, and what the pairs of near ones cost. The same for
// any number of threads.
std::vector<Overlap> find_overlaps(const std::vector<CleanTriangle>& triangles,
                                   const std::vector<MaterialId>& material,
                                   std::span<const BandMaterial> materials,
                                   const std::vector<Vec3>& positions, const Context& context);

// Removes the patches that covers hide, and returns their number. Patches must have been cut where surfaces
// end on others; one that is covered in part remains. Vertices remain, used or not.
std::size_t remove_covered(PatchSet& patches, const std::vector<Overlap>& overlaps,
                           const std::vector<CleanTriangle>& triangles, const std::vector<Vec3>& positions);

}  // namespace luxel
