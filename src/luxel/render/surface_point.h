// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "luxel/core/vector.h"
#include "luxel/patch/patch_set.h"

namespace luxel {

// A point from which rays leave one side of a patch.
struct SurfacePoint {
  std::uint32_t patch = 0;
  bool back = false;
  Vec3 position = Vec3(0.0f);  // m, lifted off the patch so that a ray cannot meet it again
  Vec3 normal = Vec3(0.0f);    // unit, away from the side
};

// weights: barycentric, of the corners b and c. The point is drawn in from the patch's edges by about twice
// the lift (a few millionths of the scene), so that it stays inside a corner between walls.
SurfacePoint surface_point(const PatchSet& patches, std::size_t patch, bool back, const Vec2& weights);

// Returns whether light that meets this side of the patch is reflected: all fronts, and backs of two-sided
// materials.
inline bool is_reflecting(const PatchSet& patches, std::size_t patch, bool back) {
  return !back || patches.material_of(patch).two_sided;
}

}  // namespace luxel
