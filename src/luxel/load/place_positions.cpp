// SPDX-License-Identifier: Apache-2.0
#include "luxel/load/place_positions.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace luxel {
namespace {

double largest(const Vec3d& v) { return std::max({v.x, v.y, v.z}); }

// Subtracting it is exact where it matters: from coordinates between half of it and twice as much.
Vec3d origin_of(const ObjMesh& mesh, double scale) {
  Vec3d low(std::numeric_limits<double>::infinity());
  Vec3d high = -low;
  for (const auto& corner : mesh.corners) {
    low = glm::min(low, mesh.positions[corner.position]);
    high = glm::max(high, mesh.positions[corner.position]);
  }
  low *= scale;
  high *= scale;
  const auto size = largest(high - low);
  if (!(size > 0.0) || largest(glm::max(glm::abs(low), glm::abs(high))) <= far_in_sizes * size)
    return Vec3d(0.0);
  int exponent = 0;
  std::frexp(size, &exponent);
  const auto unit = std::ldexp(1.0, exponent);
  return unit * glm::floor(0.5 * (low + high) / unit + 0.5);
}

}  // namespace

void place_positions(const ObjMesh& mesh, double scale, Scene& scene) {
  scene.origin = origin_of(mesh, scale);
  scene.positions.reserve(mesh.positions.size());
  if (scene.origin == Vec3d(0.0)) {
    for (const auto& p : mesh.positions) scene.positions.push_back(Vec3(p) * static_cast<float>(scale));
  } else {
    for (const auto& p : mesh.positions) scene.positions.emplace_back(p * scale - scene.origin);
  }
}

}  // namespace luxel
