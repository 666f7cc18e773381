// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/core/none.h"
#include "luxel/session/scanned_mesh.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// A ray that left the scene, and the light it took along.
struct LostRay {
  Ray ray;
  double weight = 0.0;
};

// Exit of light: through a loop of open edges, or past all surfaces in one of six directions.
struct Opening {
  std::uint32_t loop = none;  // index into ScannedMesh::loops
  int direction = 0;          // without a loop: 0 to 5 for -x +x -y +y -z +z
  Vec3 at{0.0f};              // m; the mean of where the rays cross it, or where they leave the scene's box
  double weight = 0.0;        // of all light that is lost there
  std::size_t rays = 0;
};

// Finds where light leaves, the largest loss first. A ray leaves through the last loop that it crosses: each
// loop is closed by triangles from its centre to its edges, and the ray crosses one of them. (It cannot cross
// the outline of a sheet through the sheet itself, since it would have hit it there.) Cost: a few
// milliseconds per thousand rays.
std::vector<Opening> find_openings(const ScannedMesh& mesh, const std::vector<LostRay>& lost,
                                   const Context& context);

}  // namespace luxel
