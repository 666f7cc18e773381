// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "luxel/export/plan_axes.h"
#include "luxel/patch/patch_set.h"

namespace luxel {

// The closed loops around level patches, without vertices on straight lines: plan coordinates, m,
// anticlockwise. Holes, such as columns, are left out, and so are loops of less than 0.1 m².
std::vector<std::vector<PlanPoint>> floor_outline(const PatchSet& patches,
                                                  std::span<const std::uint32_t> floor, const PlanAxes& axes);

// Two corners of the rectangle around all loops, m; at least one loop.
std::array<PlanPoint, 2> box_of(std::span<const std::vector<PlanPoint>> loops);

// m² within the loop, by the shoelace formula; negative where it is clockwise.
double area_of(std::span<const PlanPoint> loop);

// m, from the nearest point of the loop's boundary.
double distance_from(std::span<const PlanPoint> loop, const PlanPoint& point);

// Returns whether the point is within the loop, by the parity of crossings.
bool contains(std::span<const PlanPoint> loop, const PlanPoint& point);

}  // namespace luxel
