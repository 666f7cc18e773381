// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "luxel/core/vector.h"

namespace luxel {

// A cone around unit normals: its axis is the direction from which the most averted of them is averted least.
class NormalCone {
 public:
  explicit NormalCone(const Vec3d& normal) : axis_(normal), normals_{normal} {}

  const Vec3d& axis() const { return axis_; }
  double cos_half_angle() const { return cos_half_angle_; }

  // The cone around the normals of both. Approximate: the axis is found by steps towards the farthest normal
  // (Badoiu and Clarkson 2003), and of many normals only the outermost are kept; the half angle is exact for
  // those kept, within about one per cent of the exact one.
  static NormalCone around(const NormalCone& a, const NormalCone& b);

 private:
  NormalCone() = default;
  void prune();

  Vec3d axis_{0.0};
  double cos_half_angle_ = 1.0;
  std::vector<Vec3d> normals_;
};

}  // namespace luxel
