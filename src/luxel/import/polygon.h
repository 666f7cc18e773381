// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "luxel/core/vector.h"

namespace luxel {

// Cuts a polygon of n >= 3 corners into exactly n - 2 triangles of corner numbers (0 to n - 1), appended to
// `triangles`, wound as the polygon is. Strictly convex polygons become the fan of corner 0, all others are
// cut by ear clipping, which covers every polygon that does not cross itself exactly, seams to holes
// included. Any input is accepted: polygons that cross themselves or have no area still give n - 2 triangles.
// Works in the plane that shows the polygon largest. Cost: about n log n for usual polygons; the work is
// bounded, so that a hostile polygon of a hundred thousand corners costs about a second and is then fanned.
void triangulate_polygon(std::span<const Vec3> corners, std::vector<std::array<std::uint32_t, 3>>& triangles);

}  // namespace luxel
