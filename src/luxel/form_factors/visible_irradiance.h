// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "luxel/core/vector.h"
#include "luxel/form_factors/clip_polygon.h"

namespace luxel {

// A flat convex polygon that hides the surfaces behind it; its corners are stored elsewhere.
using OccludingPolygon = std::span<const Vec3d>;

// Irradiance at a point from a polygon behind opaque polygons (screens), in closed form: the polygon is
// clipped by the pyramid that the point and a screen span, beyond the screen. Scratch memory for one thread.
class VisibleIrradiance {
 public:
  // slack, m: a screen whose plane is this near to the point hides nothing.
  explicit VisibleIrradiance(double slack) : slack_(slack) {}

  // Like unit_irradiance(polygon, x, n), in [0, pi], for the part that x sees past all screens. About 0.3 us
  // per screen, more where they cut it into many fragments.
  double at(const Vec3d& x, const Vec3d& n, std::span<const Vec3d> polygon,
            std::span<const OccludingPolygon> screens);

 private:
  using Polygon = std::vector<Vec3d>;
  void hide(const Vec3d& x, OccludingPolygon screen);
  void keep(const Polygon& fragment);
  // Cuts off what the planes leave visible: the first entries of cut_off_, as many as are returned.
  std::size_t cut(const Polygon& fragment);
  static constexpr auto none_behind = std::numeric_limits<std::size_t>::max();

  double slack_;
  std::vector<Polygon> fragments_, visible_, cut_off_;
  std::size_t fragment_count_ = 0, visible_count_ = 0;
  std::vector<Plane> planes_;    // of a screen: its own, then those through the point and an edge
  std::vector<double> heights_;  // of a fragment's corners above a plane
  Polygon behind_, rest_;
};

}  // namespace luxel
