// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/patch/patch_set.h"
#include "luxel/patch/side.h"

#include "support/point_factor.h"

namespace luxel::truth {

// Irradiance of both sides of every patch, W/m², [patch][band], as in Solution.
struct TrueLight {
  FrontAndBack<double> irradiance;
};

// Form factors between all sides of a small scene, [from][to], side 2p the front of patch p and 2p + 1 its
// back. Only the screens hide patches from each other: the scene is a convex room, or all occluders are
// listed here as convex polygons, whose patches may be receivers too. Where a patch crosses the plane of
// another, front and back are distinguished point by point.
//
// The inner integral is closed (point_factor); the outer one runs over the receiver by a seven-point rule
// (degree five) on triangles that are cut in four until the rule agrees with its parts. Reciprocal by
// construction. Rows of closed rooms sum to one within 2e-8 where nothing hides, 6e-6 where shadows' edges
// cross patches (measured; the test asks for 1e-7 and 1e-5). Cost: half a second for 400 patches, three times
// that with a screen or two.
std::vector<double> form_factors(const PatchSet& patches, const std::vector<ConvexPolygon>& screens,
                                 const Context& context);

// The exact solution of H = F B, B = E + rho H + tau H of the other side over these patches (constant
// radiosity on each, backs of one-sided materials black), by Gauss-Seidel to 1e-13.
TrueLight true_light(const PatchSet& patches, const std::vector<double>& form_factors);

}  // namespace luxel::truth
