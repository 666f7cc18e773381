// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "luxel/photometry/photometry.h"

namespace luxel {

// Returns whether the opening is a sheet, which has two sides.
bool is_flat(const LuminousOpening& opening);

// Area of the opening as seen from far away in a direction, m²; 0 for a point. direction: local axes, of any
// length above 0. Flat openings are seen from both sides.
double projected_area(const LuminousOpening& opening, const Vec3d& direction);

// A point of the opening, local axes, m: uniform over the area of a flat opening, over the surface of a box
// or cylinder, and over a sphere that is scaled to an ellipsoid; the centre of a point. That each point emits
// the whole distribution keeps the flux, and far away it is the distribution itself. u: uniform in [0, 1).
Vec3d sample_opening(const LuminousOpening& opening, const std::array<double, 2>& u);

// Distance to the first point of the opening on a ray in local axes, m; nothing where the ray misses it, and
// for a point. direction: unit.
std::optional<double> meet_opening(const LuminousOpening& opening, const Vec3d& origin,
                                   const Vec3d& direction);

// Returns whether the point lies in the opening or within a margin of it, m. point: local axes.
bool holds(const LuminousOpening& opening, const Vec3d& point, double margin);

// Radius of the sphere about the centre that holds the opening, m.
double bounding_radius(const LuminousOpening& opening);

}  // namespace luxel
