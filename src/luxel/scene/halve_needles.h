// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "luxel/scene/fragment_mesh.h"

namespace luxel {

// Turns edges inside the mesh until the angles opposite each are at most 180 degrees together: the
// constrained Delaunay triangulation of the same points (Lawson 1977), whose smallest angle is as large as
// any has. An edge stays where it would make a triangle of less than this height, in steps of the grid.
void make_delaunay(FragmentMesh& mesh, double min_height);

// Lengths are in steps of the grid.
struct NeedleLimits {
  double slenderness = 10.0;  // longest edge over height, above which a triangle is a needle
  double longest = 0.0;       // needles with no edge longer than this stay
  double min_height = 0.0;    // see make_delaunay()
  std::size_t points = 0;     // that may be added
};

// Returns whether a triangle is a needle that others continue at two long sides: part of a fan or of a band
// of needles, and not half of a narrow rectangle.
bool is_needle_inside(const FragmentMesh& mesh, std::uint32_t fragment, const NeedleLimits& limits);

// Adds points to a Delaunay mesh until no triangle is such a needle: from a needle to the neighbour at its
// longest edge, and so on, to an edge that is the longest of both triangles or bounds the mesh. It is halved,
// and the mesh made Delaunay again (Rivara's longest-edge propagation path). Returns the ends of the edges
// that were halved, one pair per added point, in their order; as many as allowed where needles are left.
std::vector<FragmentMesh::Ends> halve_needles(FragmentMesh& mesh, const NeedleLimits& limits);

}  // namespace luxel
