// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "luxel/core/discrete_distribution.h"
#include "luxel/patch/patch_set.h"
#include "luxel/patch/side.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// Random places on the surfaces of a scene, and cosine rays from there.
class StartSides {
 public:
  // Keeps a reference. Half of the places are dealt by area, half by input triangle, so that a house in a
  // wide landscape gets its part. Patches where may_start is 0 get none; empty: all may. Two-sided surfaces
  // give both of their sides.
  StartSides(const PatchSet& patches, const std::vector<std::uint8_t>& may_start);

  bool empty() const { return !(by_weight_.total() > 0.0); }
  // A side, from a uniform number.
  SideId pick(float u) const;

 private:
  const PatchSet& patches_;
  DiscreteDistribution by_weight_;  // of patches
};

// A cosine ray from a point of a side, given by the weights of its corners 1 and 2. The point moves by a
// thousandth of the way to the centroid, away from the edges, and is lifted off the surface, so that rounding
// takes no ray through a wall. u1, u2: uniform.
Ray ray_from_side(const PatchSet& patches, SideId side, const Vec2& weights, float u1, float u2);
// Starts from a uniform point of the side. u: uniform.
Ray ray_from_side(const PatchSet& patches, SideId side, const std::array<float, 4>& u);

}  // namespace luxel
