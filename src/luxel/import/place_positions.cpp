// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/place_positions.h"

#include <algorithm>
#include <cmath>

namespace luxel {
namespace {

double largest(const Vec3d& v) { return std::max({v.x, v.y, v.z}); }

// Subtracting the origin is exact where it matters: from coordinates between half of it and twice as much.
Vec3d origin_of(const Reach& reach, double scale) {
  const auto low = scale * reach.low, high = scale * reach.high;
  const auto size = largest(high - low);
  if (!(size > 0.0) || largest(glm::max(glm::abs(low), glm::abs(high))) <= far_in_sizes * size)
    return Vec3d(0.0);
  int exponent = 0;
  std::frexp(size, &exponent);
  const auto unit = std::ldexp(1.0, exponent);
  return unit * glm::floor(0.5 * (low + high) / unit + 0.5);
}

}  // namespace

void place_positions(std::span<const Vec3d> positions, const Reach& reach, double scale, Scene& scene) {
  scene.origin = origin_of(reach, scale);
  scene.positions.reserve(positions.size());
  if (scene.origin == Vec3d(0.0)) {
    for (const auto& p : positions) scene.positions.push_back(Vec3(p) * static_cast<float>(scale));
  } else {
    for (const auto& p : positions) scene.positions.emplace_back(p * scale - scene.origin);
  }
}

}  // namespace luxel
