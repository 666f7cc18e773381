// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "luxel/core/vector.h"
#include "luxel/lamps/outline_edges.h"
#include "luxel/patch/flat_triangle.h"
#include "luxel/scene/point_light.h"

namespace luxel {

// The plane of a triangle as a punctual light reaches it: edges are projected onto it from the light,
// parallel or central.
class ShadowProjection {
 public:
  // Keeps references. Suns less than 1.2 degrees above the plane are left out: see reaches().
  ShadowProjection(const PointLight& light, const FlatTriangle& plane);

  // Returns whether the light is far enough above the plane or, from behind, below it.
  bool reaches() const { return side_ != 0.0; }
  bool from_behind() const { return side_ < 0.0; }
  Vec3d lit_side() const { return side_ * plane_.normal; }

  // Returns whether a point is between the light and the plane. slack: m, of points on the plane.
  bool is_between(const Vec3d& point, double slack) const;

  // The shadow of the part of an edge that is between the light and the plane. slack: m, of points on the
  // plane. Nothing where no part is.
  std::optional<std::array<Vec3d, 2>> shadow(const OutlineEdge& edge, double slack) const;

 private:
  Vec3d project(const Vec3d& point) const;
  double height(const Vec3d& point) const { return side_ * plane_.height(point); }

  const PointLight& light_;
  const FlatTriangle& plane_;
  double side_ = 0.0;          // 1: the light is before the front; -1: behind it
  double light_height_ = 0.0;  // m, infinite for directional lights
};

}  // namespace luxel
