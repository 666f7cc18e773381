// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "luxel/core/vector.h"
#include "luxel/lamps/shadow_receivers.h"
#include "luxel/patch/flat_triangle.h"
#include "luxel/patch/patch_set.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// Tests by pairs of shadow rays where along a line the light of a point or a sun ends.
class ShadowTest {
 public:
  // Keeps references. reach: m, distance of both points of a pair from the line.
  ShadowTest(const PatchSet& triangles, const Tracer& tracer, const EdgeShadow& shadow, double reach);

  // Whether, at this fraction of the line's length, the outer point is lit and the inner one is not: at
  // `reach`, or at a tenth of it, as at the tip of an acute angle. Cost: at most four rays.
  bool divides(double fraction) const;

 private:
  bool divides_at(const Vec3d& at, double reach) const;
  double distance_inside(const Vec3d& from, const Vec3d& way) const;
  bool is_lit(const Vec3d& point) const;

  const EdgeShadow& shadow_;
  const PointLight& light_;
  const Tracer& tracer_;
  FlatTriangle plane_;
  double lift_ = 0.0;  // m, of the rays' origins
  double reach_;
  Vec3d outer_{0.0};  // unit, in the plane, at right angles to the line, to the lit side
};

}  // namespace luxel
