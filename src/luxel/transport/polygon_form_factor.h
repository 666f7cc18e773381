// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "luxel/math/vector.h"

namespace luxel {

// The form factor from polygon a to polygon b: the share of the diffuse power that leaves the front of a and
// arrives at the front of b, in [0, 1], with nothing between them. Corners in metres, counter-clockwise seen
// from the front; flat, convex, at least three, else 0. The part of either that lies behind the plane of the
// other neither gives nor gets. They may touch, share edges, and be as near as they like.
//
// Absolute error at most about 1e-12.
double polygon_form_factor(std::span<const Vec3d> a, std::span<const Vec3d> b);

// The same times the area of a, m²: what both directions have in common.
double polygon_exchange_area(std::span<const Vec3d> a, std::span<const Vec3d> b);

}  // namespace luxel
