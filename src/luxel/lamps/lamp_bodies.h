// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "luxel/core/vector.h"
#include "luxel/patch/patch_set.h"

namespace luxel {

// A lamp as a body: the emissive triangles of a LampSurface.
struct LampBody {
  BandPointLight centre;        // a point light of its flux, in the middle of its emission
  std::vector<Vec3d> vertices;  // m
  double radius = 0.0;          // m, of a ball around the centre
};

// Finds the lamps that may have shadows with visible edges: those smaller than a quarter of the scene's
// diagonal, at most `most` of them, those of the greatest flux first, and none of less than a fiftieth of the
// first. triangles: see find_shadow_lines(). Cost: linear.
std::vector<LampBody> find_lamp_bodies(const PatchSet& triangles, std::size_t most);

}  // namespace luxel
