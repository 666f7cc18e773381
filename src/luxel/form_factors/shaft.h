// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "luxel/core/bounds.h"
#include "luxel/core/vector.h"
#include "luxel/form_factors/clip_polygon.h"

namespace luxel {

// The region between two flat convex polygons: the convex hull of both (Haines and Wallace 1991).
class Shaft {
 public:
  // slack, m: polygons that reach less than this into the shaft count as outside.
  Shaft(std::span<const Vec3d> a, std::span<const Vec3d> b, double slack);

  // Returns whether a box is outside. Conservative: may return false for a box that is.
  bool misses(const Bounds& box) const;
  // Returns whether a flat convex polygon blocks no line between a and b: it is outside, or is seen edge on.
  // By separating axes: no result is wrong by more than the slack.
  bool misses(std::span<const Vec3d> polygon) const;

 private:
  bool is_parted(const Vec3d& axis, std::span<const Vec3d> polygon) const;

  double slack_;
  std::vector<Vec3d> corners_;
  std::vector<Vec3d> edges_;  // of the hull, as vectors, and some more between corners of one face
  std::vector<Plane> faces_;  // upper side outside
  Vec3d low_, high_;
};

// Returns whether a flat convex polygon, the screen, blocks every line between a and b. Only the lines
// between their corners are tested: all others cross the screen's plane within the hull of where these do.
// False where a or b comes nearer to that plane than slack, m.
bool hides_all(std::span<const Vec3d> screen, std::span<const Vec3d> a, std::span<const Vec3d> b,
               double slack);

}  // namespace luxel
