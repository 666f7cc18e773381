// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <numbers>

#include <glm/glm.hpp>

namespace luxel {

using Vec2 = glm::vec2;
using Vec3 = glm::vec3;  ///< a point or vector in metres, or a linear sRGB colour
using Vec3d = glm::dvec3;

inline constexpr float pi = std::numbers::pi_v<float>;

/// Relative luminance of a linear sRGB colour (IEC 61966-2-1, Rec. 709 primaries).
inline float luminance(const Vec3& rgb) { return 0.2126f * rgb.r + 0.7152f * rgb.g + 0.0722f * rgb.b; }

inline bool is_finite(const Vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace luxel
