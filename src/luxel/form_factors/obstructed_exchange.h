// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "luxel/core/vector.h"
#include "luxel/form_factors/visible_irradiance.h"

namespace luxel {

// An integral and an estimate of its absolute error.
struct Estimate {
  double value = 0.0;
  double error = 0.0;
};

struct ObstructedOptions {
  double tolerance = 1e-6;    // m², absolute, asked for
  double slack = 0.0;         // m: what reaches less than that between the polygons hides nothing
  std::size_t most = 20'000;  // cells; past them `error` stays above the tolerance
};

// Computes area times form factor, m², between two polygons that face each other (facing_parts) with opaque
// polygons between. open: the same without them. The inner integral is exact (VisibleIrradiance), the outer
// runs over the smaller polygon, whose triangles are cut in four where the estimated error is largest. Each
// cell lists the occluders in its own shaft, so that shadow edges alone are refined. Where most is visible,
// only the hidden part is integrated, and the rest is the closed form: edges that touch then cost nothing.
//
// error: twice the sum over cells of the change by the last cut, and, where all points of a cell are in the
// light (or dark) though an occluder reaches in, an estimate of what they miss. 10 us per cell and occluder.
Estimate obstructed_exchange(std::span<const Vec3d> a, std::span<const Vec3d> b,
                             std::span<const OccludingPolygon> screens, double open,
                             const ObstructedOptions& options);

}  // namespace luxel
