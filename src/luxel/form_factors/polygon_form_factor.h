// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "luxel/core/vector.h"

namespace luxel {

// Returns the form factor from polygon a to polygon b: the fraction of the diffuse power leaving the front of
// a that arrives at the front of b, in [0, 1], without occlusion. Corners in metres, counter-clockwise seen
// from the front; flat, convex, at least three, else 0. Parts of either behind the plane of the other do not
// contribute. The polygons may touch, share edges, and be arbitrarily near.
//
// Near each other: the closed form (Schröder and Hanrahan 1993), pair by pair of edges. Where a polygon is
// further off than its own size: the closed form of a point (Lambert 1760), integrated over the smaller of
// the two by Gauss's rule, which loses no digits at a distance. Absolute error at most about 1e-12, relative
// the same when apart. 1 to 15 us for two triangles, 300 us at worst.
double polygon_form_factor(std::span<const Vec3d> a, std::span<const Vec3d> b);

// Returns the form factor times the area of a, m², which is the same in both directions.
double polygon_exchange_area(std::span<const Vec3d> a, std::span<const Vec3d> b);

// The parts of two polygons in front of each other's plane, which can see each other. Empty if there are
// none. Corners in the other's plane but for rounding stay as they are.
struct FacingParts {
  std::vector<Vec3d> a, b;
};
FacingParts facing_parts(std::span<const Vec3d> a, std::span<const Vec3d> b);

// Half the sum of the cross products of its edges: length its area in m², direction its front. Zero for less
// than three corners.
Vec3d polygon_area_vector(std::span<const Vec3d> polygon);

}  // namespace luxel
