// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "luxel/core/warp.h"
#include "luxel/patch/patch_set.h"
#include "luxel/patch/side.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// Rays that leave one side of a patch: a uniform point, a cosine direction. Together the density of diffuse
// power, so that a ray carries the same power wherever it starts and goes. Points keep twice the origin's
// lift away from the patch's edges, so that a lifted origin stays inside a corner between walls.
class PatchEmitter {
 public:
  PatchEmitter(const PatchSet& patches, SideId side);

  // u: four numbers uniform in [0, 1).
  Ray ray(const std::array<float, 4>& u) const {
    return ray(uniform_triangle(u[0], u[1]), cosine_hemisphere(u[2], u[3]));
  }
  // The same from numbers already warped: weights of the corners b and c, a direction about +z.
  Ray ray(const Vec2& weights, const Vec3& local) const { return {point(weights), frame_.to_world(local)}; }
  // The origin of such a ray alone.
  Vec3 point(float u1, float u2) const { return point(uniform_triangle(u1, u2)); }
  // The area that the origins cover, and the side that they face.
  std::array<Vec3, 3> corners() const { return {base_, base_ + edge_b_, base_ + edge_c_}; }
  const Vec3& normal() const { return frame_.n; }

 private:
  Vec3 point(const Vec2& weights) const { return base_ + weights.x * edge_b_ + weights.y * edge_c_; }

  Vec3 base_, edge_b_, edge_c_;  // corners drawn in and lifted
  Frame frame_;
};

}  // namespace luxel
