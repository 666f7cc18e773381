// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "luxel/core/vector.h"

namespace luxel {

// A triangle of light as the mesh has it.
struct LampFacet {
  std::array<Vec3, 3> corner;  // m, counter-clockwise seen from the front
  std::size_t surface = 0;     // facets of one surface shine alike
};

// Facets that are one lamp.
struct JoinedLamp {
  std::vector<Vec3> corners;          // of a convex polygon, counter-clockwise seen from the front
  std::vector<std::uint32_t> facets;  // that fill it
};

// Joins facets that share edges, lie in one plane but for the rounding of floats, belong to one surface and
// fill a convex polygon with at most half as many triangles (the facets of a meshed panel become a panel
// again). All others stay as they are, one triangle each. Every facet, none of them without area, is in one
// lamp. Cost: n log n.
std::vector<JoinedLamp> join_lamps(std::span<const LampFacet> facets);

}  // namespace luxel
