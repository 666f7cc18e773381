// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <vector>

#include "luxel/core/vector.h"

namespace luxel {

// Irradiance at a point from a polygon behind opaque triangles, in closed form: the polygon is clipped by the
// pyramid that the point and a triangle span, beyond the triangle. Scratch memory for one thread.
class VisibleIrradiance {
 public:
  // slack, m: a triangle in whose plane the point lies so nearly hides nothing.
  explicit VisibleIrradiance(double slack) : slack_(slack) {}

  // As unit_irradiance(polygon, x, n), in [0, pi]: of what x sees past all screens. About 0.3 us a screen,
  // more where they cut it into many fragments.
  double at(const Vec3d& x, const Vec3d& n, std::span<const Vec3d> polygon,
            std::span<const std::array<Vec3d, 3>> screens);

 private:
  using Polygon = std::vector<Vec3d>;
  void hide(const Vec3d& x, const std::array<Vec3d, 3>& screen);
  void keep(const Polygon& fragment);

  double slack_;
  std::vector<Polygon> fragments_, visible_, cut_off_;
  std::size_t fragment_count_ = 0, visible_count_ = 0;
  Polygon behind_, rest_;
};

}  // namespace luxel
