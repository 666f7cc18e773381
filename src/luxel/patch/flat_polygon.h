// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "luxel/core/vector.h"

namespace luxel {

using Triangle3 = std::array<Vec3, 3>;

// A plane with two axes in it: where its triangles lie, as numbers of two dimensions.
struct FlatFrame {
  Vec3d origin{0.0};            // m, in the plane
  Vec3d normal{0.0};            // unit
  std::array<Vec3d, 2> axis{};  // unit, at right angles; (axis 0, axis 1, normal) is right-handed

  std::array<double, 2> flat(const Vec3& point) const;
  Vec3 in_space(const std::array<double, 2>& point) const;
};

// The plane of triangles that lie in one, through their mean; the first axis goes along the direction in
// which most of their edges run, or at right angles to it, so that rectangles stand upright. None without
// area.
FlatFrame frame_of(std::span<const Triangle3> triangles, std::span<const std::uint32_t> members);

// The corners of the convex hull, counter-clockwise, without points on its edges: fewer than three where all
// points lie on a line. n log n.
std::vector<std::array<double, 2>> convex_hull(std::vector<std::array<double, 2>> points);
double area_of(std::span<const std::array<double, 2>> polygon);

// Triangles that lie in one plane, whichever way they face, by their first triangle; those without area are
// in none. tolerance, m: of their distances from the plane. A plane so near a limit of the classes of
// planes that rounding parts its triangles comes out as two; that is rare (rounding over tolerance). Linear.
std::vector<std::vector<std::uint32_t>> group_by_plane(std::span<const Triangle3> triangles,
                                                       double tolerance);

}  // namespace luxel
