// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "luxel/photometry/photometry.h"

namespace luxel {

// A point of an opening, local axes, m, and the uniform density over the density it was drawn with.
struct OpeningPoint {
  Vec3d at{0.0};
  double weight = 1.0;
};

// Returns whether a receiver, local axes, is so close to the opening that points near it give most of its
// light: sample_opening() finds them seldom. Costs some nanoseconds.
bool is_close_to(const LuminousOpening& opening, const Vec3d& receiver);

// As sample_opening(), for such a receiver. Most points of sheets and boxes are spread evenly over the solid
// angle of a face, and weighted by the balance heuristic (Veach and Guibas 1995). The weight is 0 for places
// of an ellipse's rectangle beside it. Cylinders and ellipsoids: as sample_opening(). u: uniform in [0, 1).
// Costs about 400 ns.
OpeningPoint sample_opening_from(const LuminousOpening& opening, const Vec3d& receiver,
                                 const std::array<double, 2>& u);

}  // namespace luxel
