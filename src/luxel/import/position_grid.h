// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "luxel/core/vector.h"
#include "luxel/import/gltf_file.h"
#include "luxel/import/gltf_packing.h"

namespace luxel {

// The positions of a mesh as integers of 16 bits: origin + step * integer, in the mesh's own coordinates.
struct PositionGrid {
  Vec3d origin = Vec3d(0.0);
  double step = 1.0;
  bool as_floats = false;  // the mesh is too large for 16 bits: its floats are rounded to the grid

  Vec3d index_of(const Vec3d& position) const { return glm::round((position - origin) / step); }
  Vec3d rounded(const Vec3d& position) const { return origin + step * index_of(position); }
};

// Returns the grid of each mesh; none where it may have none (may_have: [mesh]), where no node of the scene
// shows it, and where no mesh fits into max_steps() of max_step.
//
// All meshes have one step, measured in the scene: the smallest power of two in which the largest mesh fits.
// Where nodes are not turned against each other, except by quarter turns, the points of all grids coincide in
// the scene, so that vertices that meet still do. Meshes that share an array of positions share a grid.
std::vector<std::optional<PositionGrid>> position_grids(GltfFile& file, const std::vector<bool>& may_have,
                                                        const GltfPacking& packing);

}  // namespace luxel
