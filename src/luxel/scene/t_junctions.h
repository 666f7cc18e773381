// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "luxel/scene/edges.h"

namespace luxel {

// A vertex that lies inside an open edge of another triangle, along which an open edge of its own runs: two
// surfaces meet there without sharing their vertices.
struct TJunction {
  std::uint32_t vertex = 0;
  std::uint32_t edge = 0;
};

struct TJunctions {
  std::vector<TJunction> found;         // by edge, then by vertex
  std::vector<std::uint8_t> is_welded;  // [edge]: open, and another open edge runs along it
};

// Maximum distance of places that are meant to be the same, m: four roundings of the largest coordinate, plus
// the resolution of six decimal digits of the whole extent.
double rounding_distance(std::span<const Vec3> places);

// Only open edges and their vertices are tested: a table's leg on a floor is no T-junction. A tree of the
// vertices finds those near an edge: n log n where edges pass few vertices that they do not touch, as in all
// known meshes. (No method is known to be that fast for every set of points and lines.)
TJunctions find_t_junctions(std::span<const Vec3> places, const Edges& edges, double tolerance);

}  // namespace luxel
