// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "luxel/core/trig.h"
#include "luxel/core/vector.h"

namespace luxel {

// A triangle as seen from the origin: its solid angle, and directions uniform in it. Arvo 1995 in the form of
// Peters 2021 (half angles instead of angles), which loses no digits where the triangle is small, thin or
// seen from the side. One arc tangent to make, one sine and cosine a direction: about 100 ns together.
class SphericalTriangle {
 public:
  // corner: relative to the eye, m; none of them zero. Either orientation.
  explicit SphericalTriangle(const std::array<Vec3d, 3>& corner) {
    const std::array<double, 3> length = {glm::length(corner[0]), glm::length(corner[1]),
                                          glm::length(corner[2])};
    assert(length[0] > 0.0 && length[1] > 0.0 && length[2] > 0.0);
    a_ = corner[0] / length[0];
    b_ = corner[1] / length[1];
    const auto c = corner[2] / length[2];
    // Towards c from a along the arc: (a x c) x a, the cross product from the difference.
    const auto normal = glm::cross(a_, (corner[2] - corner[0]) / length[2]);
    tangent_ = glm::cross(normal, a_);
    const auto sine = glm::length(tangent_);
    if (sine > 0.0) tangent_ /= sine;
    // The volume spanned, from the differences too.
    const auto volume =
        std::fabs(glm::dot(corner[0], glm::cross(corner[1] - corner[0], corner[2] - corner[0])));
    const auto product = length[0] * length[1] * length[2];
    volume_ = sine > 0.0 ? volume / (product * sine) : 0.0;
    one_plus_ab_ = 1.0 + glm::dot(a_, b_);
    b_dot_tangent_ = glm::dot(b_, tangent_);
    // Van Oosterom and Strackee 1983.
    half_solid_angle_ =
        arc_tangent(volume / product, 1.0 + glm::dot(a_, b_) + glm::dot(b_, c) + glm::dot(c, a_));
  }

  // sr, in [0, 2 pi].
  double solid_angle() const { return 2.0 * half_solid_angle_; }
  // Per steradian, within the triangle.
  double density() const { return 0.5 / half_solid_angle_; }

  // A unit direction from two numbers in [0, 1). u1 cuts off the triangle a b c' with this fraction of the
  // solid angle, u2 runs from b (0) to c' (1). Where the solid angle is zero: b.
  Vec3d direction(double u1, double u2) const {
    assert(u1 >= 0.0 && u1 <= 1.0 && u2 >= 0.0 && u2 <= 1.0);
    const auto [s, c] = sin_cos(u1 * half_solid_angle_);
    // tan(phi / 2) = m / d, phi the arc from a to c'.
    const auto m = s * one_plus_ab_;
    const auto d = c * volume_ - s * b_dot_tangent_;
    const auto norm = m * m + d * d;
    if (!(norm > 0.0)) return b_;
    const auto from_a = (2.0 * m / norm) * (d * tangent_ - m * a_);
    const auto cut = a_ + from_a;
    // The height of the cap around b, without cancellation: 1 - cos = |c' - b|² / 2.
    const auto chord = cut - b_;
    const auto cap = 0.5 * glm::dot(chord, chord);
    const auto across = chord + cap * b_;
    const auto across_length = glm::length(across);
    if (!(across_length > 0.0)) return b_;
    const auto height = u2 * cap;
    return (1.0 - height) * b_ + (std::sqrt(height * std::max(0.0, 2.0 - height)) / across_length) * across;
  }

 private:
  Vec3d a_, b_, tangent_;
  double volume_;  // of a, b and the tangent
  double one_plus_ab_, b_dot_tangent_;
  double half_solid_angle_;
};

}  // namespace luxel
