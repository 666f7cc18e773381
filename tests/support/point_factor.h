// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "luxel/core/vector.h"

namespace luxel::truth {

// A convex polygon that grows by clipping. Sixteen corners: a triangle cut by a horizon and by a few
// quadrilateral screens; more is a logic_error.
struct ConvexPolygon {
  std::array<Vec3d, 16> corner;
  std::size_t size = 0;

  void add(const Vec3d& p);
};
ConvexPolygon convex_polygon(std::span<const Vec3> corners);

// The form factor from a point with the unit normal n to the polygon, seen from either of its sides, behind
// opaque convex screens: the closed form for a whole polygon (Lambert 1760; Baum, Rushmeier and Winget 1989,
// eq. 9), summed over the convex pieces that the point sees. Exact to rounding: a screen is cut out by the
// pyramid over it, not sampled. A screen in whose plane the point or the polygon lies hides nothing of it.
double point_factor(const Vec3d& point, const Vec3d& n, const ConvexPolygon& polygon,
                    std::span<const ConvexPolygon> screens);

}  // namespace luxel::truth
