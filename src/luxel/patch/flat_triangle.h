// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "luxel/core/vector.h"

namespace luxel {

// Half a unit in the last place of the largest coordinate, m: how far floats round a place near these.
double coordinate_rounding(const std::array<Vec3, 3>& corners);

// A triangle with its plane, in double, for locating points near it. Edge k runs from corner k to the
// next.
struct FlatTriangle {
  // The normal, of any length but 0, need not be exactly that of the corners: theirs may be rounded.
  FlatTriangle(const std::array<Vec3, 3>& corners, const Vec3d& normal);
  explicit FlatTriangle(const std::array<Vec3, 3>& corners);

  std::array<Vec3d, 3> corner;
  Vec3d normal;                 // unit
  std::array<Vec3d, 3> inward;  // of each edge: unit, in the plane, at right angles to it, to the inside

  double height(const Vec3d& p) const { return glm::dot(normal, p - corner[0]); }
  // Distance from edge k's line, above 0 inside.
  double inside(std::size_t k, const Vec3d& p) const { return glm::dot(inward[k], p - corner[k]); }
  double smallest_height() const;  // m, of a corner over the edge that faces it
  Vec3d foot_point(const Vec3d& p) const { return p - height(p) * normal; }
  // Position of p along edge k: 0 and 1 are its ends.
  double along(std::size_t k, const Vec3d& p) const;
};

// An interval of a segment: shares of its length, 0 <= begin <= end <= 1.
struct Interval {
  double begin = 0.0;
  double end = 1.0;
};

// The interval of the segment from p to q that lies above or below the triangle, or beyond its edges by no
// more than slack (m).
std::optional<Interval> interval_over(const FlatTriangle& triangle, const Vec3d& p, const Vec3d& q,
                                      double slack);

// Where a segment lies on an edge: no farther from it than slack (m).
struct EdgeInterval {
  std::size_t edge = 0;
  Interval interval;    // of the edge; from p to q, so begin may be above end
  double length = 0.0;  // m
};
std::optional<EdgeInterval> interval_on_edge(const FlatTriangle& triangle, const Vec3d& p, const Vec3d& q,
                                             double slack);

// Returns the part of a segment that lies over the triangle, exactly; or, where that is a point at most, the
// part within slack along an edge of it. Returns nothing where the part is not longer than slack.
std::optional<Interval> interval_on(const FlatTriangle& triangle, const Vec3d& p, const Vec3d& q,
                                    double slack);

}  // namespace luxel
