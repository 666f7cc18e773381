// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>

#include "luxel/core/vector.h"

namespace luxel {

// From uniform numbers to points and directions, each with its density beside it. Only IEEE-exact operations
// (+ - * / and sqrt, no library sines), so that every host gets the same bits.

// sin and cos of an angle in [-pi/4, pi/4], by their Taylor series to the 9th and 8th power: error below
// 3e-8, half a unit in the last place of a float near 1.
inline void sin_cos_octant(float angle, float& sine, float& cosine) {
  const float x2 = angle * angle;
  sine =
      angle * (1.0f + x2 * (-1.0f / 6.0f + x2 * (1.0f / 120.0f + x2 * (-1.0f / 5040.0f + x2 / 362880.0f))));
  cosine = 1.0f + x2 * (-0.5f + x2 * (1.0f / 24.0f + x2 * (-1.0f / 720.0f + x2 / 40320.0f)));
}

// The unit square onto the unit disk, areas kept in proportion (Shirley and Chiu 1997). Strata stay compact.
inline Vec2 concentric_disk(float u1, float u2) {
  assert(u1 >= 0.0f && u1 <= 1.0f && u2 >= 0.0f && u2 <= 1.0f);
  const float a = 2.0f * u1 - 1.0f;
  const float b = 2.0f * u2 - 1.0f;
  // Without branches: processors cannot predict which half it is.
  const bool wide = std::abs(a) > std::abs(b);
  const float radius = wide ? a : b;
  const float across = wide ? b : a;
  float sine = 0.0f;
  float cosine = 0.0f;
  sin_cos_octant((pi / 4.0f) * (across / (radius == 0.0f ? 1.0f : radius)), sine, cosine);
  const float along = radius * cosine;
  const float aside = radius * sine;
  return {wide ? along : aside, wide ? aside : along};
}
inline float concentric_disk_density(const Vec2& p) { return glm::dot(p, p) <= 1.0f ? 1.0f / pi : 0.0f; }

// Cosine-distributed direction about +z (Malley's method, 1988), z > 0 but for rounding at the rim.
inline Vec3 cosine_hemisphere(float u1, float u2) {
  const auto d = concentric_disk(u1, u2);
  return {d.x, d.y, std::sqrt(std::max(0.0f, 1.0f - d.x * d.x - d.y * d.y))};
}
// Per steradian.
inline float cosine_hemisphere_density(const Vec3& direction) { return std::max(0.0f, direction.z) / pi; }

// Evenly distributed direction about +z, z >= 0, by the map of equal areas from the disk (Shirley and Chiu
// 1997). Density: 1 / (2 pi) per steradian everywhere.
inline Vec3 uniform_hemisphere(float u1, float u2) {
  const auto d = concentric_disk(u1, u2);
  const auto r2 = std::min(1.0f, glm::dot(d, d));
  const auto across = std::sqrt(2.0f - r2);
  return {across * d.x, across * d.y, 1.0f - r2};
}

// Uniform barycentric coordinates (weights of b and c; a gets the rest), by the square-root warp (Turk 1990).
// Density: 1 / area everywhere.
inline Vec2 uniform_triangle(float u1, float u2) {
  assert(u1 >= 0.0f && u1 <= 1.0f && u2 >= 0.0f && u2 <= 1.0f);
  const float root = std::sqrt(u1);
  return {(1.0f - u2) * root, u2 * root};
}
inline float uniform_triangle_density(float area) {
  assert(area > 0.0f);
  return 1.0f / area;
}

// A right-handed orthonormal frame whose third axis is the unit vector n (Duff et al. 2017).
struct Frame {
  Vec3 s, t, n;

  explicit Frame(const Vec3& normal) : n(normal) {
    assert(std::abs(glm::dot(normal, normal) - 1.0f) < 1e-4f);
    const float sign = std::copysign(1.0f, n.z);
    const float a = -1.0f / (sign + n.z);
    const float b = n.x * n.y * a;
    s = {1.0f + sign * n.x * n.x * a, sign * b, -sign * n.x};
    t = {b, sign + n.y * n.y * a, -n.y};
  }
  Vec3 to_world(const Vec3& local) const { return local.x * s + local.y * t + local.z * n; }
};

}  // namespace luxel
