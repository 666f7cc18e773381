// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <span>

#include "luxel/scene/scene.h"

namespace luxel {

// Largest distance of a scene from the file's zero, in units of its own size (the longest side of its box),
// before its positions are relative to an origin of their own. Up to this distance floats resolve a millionth
// of the scene's size.
inline constexpr double far_in_sizes = 8.0;

// Bounding box of the vertices that faces use, in the file's coordinates.
struct Reach {
  Vec3d low = Vec3d(std::numeric_limits<double>::infinity());
  Vec3d high = Vec3d(-std::numeric_limits<double>::infinity());

  void add(const Vec3d& position) {
    low = glm::min(low, position);
    high = glm::max(high, position);
  }
};

// Fills positions and origin of the scene: coordinates times scale, in floats. Where the reach of all that
// faces use goes farther than far_in_sizes, they are taken in doubles from its middle, rounded along each
// axis to a multiple of the power of two that is next above its longest side.
void place_positions(std::span<const Vec3d> positions, const Reach& reach, double scale, Scene& scene);

}  // namespace luxel
