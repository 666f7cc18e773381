// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "luxel/core/context.h"
#include "luxel/core/vector.h"
#include "luxel/patch/contact_lines.h"
#include "luxel/scene/clean_triangles.h"

namespace luxel {

// Finds the outlines of things that hang close before a surface, a picture before a wall or a luminaire below
// a ceiling: the part they hide is dark, and patches half behind them would spread the darkness into the
// light beside them. A line is an edge of a triangle, projected along the normal of the triangle `on` onto
// it, where
// - both ends are before the front of `on`, farther than contacts are and no farther than its reach:
//   `distance`, but a tenth of the height of `on` if that is lower than `distance`;
// - the edge is about parallel to the plane and belongs to the outline as seen along the normal;
//   or, within a fifth of `distance`, is the foot of a surface that stands on the plane, as the back edge of
//   a shelf that does not quite touch the wall;
// - it is longer than three of its heights before the plane; but at least a tenth of `distance`, or of the
//   height of `on` if that is lower; and at most a quarter of `distance`.
// They are lines as find_contact_lines() gives them where a triangle lies flat on another one, in the same
// order, with `into` along the normal of `on`. An outline has no openings where it crosses edges of
// triangles: the darkness would spread from there.
//
// distance: m, about a third of the longest edge of patches: patches resolve the shadows of wider gaps. gap:
// and most: as for find_contact_lines(). The same bits for any number of threads. Cost: as
// find_contact_lines().
std::vector<ContactLine> find_near_lines(const std::vector<CleanTriangle>& triangles,
                                         const std::vector<Vec3>& positions, double gap, double distance,
                                         std::size_t most, const Context& context);

}  // namespace luxel
