// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "luxel/scene/scene.h"

namespace luxel {

// For each point the index of the one that takes its place: itself, or a point not farther than `distance`
// (m). Points are taken in their order; one within reach of points that stayed goes to the nearest of them
// (of equals the first), any other stays. So no point moves farther than the distance, those that stay are
// farther apart than it, and a chain of points, each near the next, does not collapse: it is thinned out. The
// same answer on every host. Linear: cells as wide as the distance, in each of which only a few can stay.
// Throws InputError where the distance is negative or not finite; 0 moves nothing.
std::vector<std::uint32_t> weld_points(std::span<const Vec3> points, double distance);

struct WeldReport {
  std::size_t places = 0;     // vertices at different places, before
  std::size_t moved = 0;      // of those, how many went to another one
  std::size_t collapsed = 0;  // triangles that had area before and have none now
  double farthest = 0.0;      // m, moved at most

  // Describes the changes as a sentence.
  std::string as_text(double distance) const;
};

// Moves the vertices of the scene's triangles so that those nearer than distance (m) have one position, by
// the rule of weld_points(). Triangles, and the number of vertices, are unchanged. Costs about 0.5 s per
// million vertices.
WeldReport weld_vertices(Scene& scene, double distance);

}  // namespace luxel
