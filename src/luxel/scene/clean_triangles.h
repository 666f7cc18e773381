// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/scene/scene.h"
#include "luxel/scene/vertex_weld.h"

namespace luxel {

// An input triangle that carries light.
struct CleanTriangle {
  std::array<std::uint32_t, 3> corners;  // into the weld
  std::uint32_t triangle = 0;            // index in the scene
  bool opposite_twin = false;            // another triangle lay on it, facing the other way
};

// A triangle that lies exactly on one that is kept.
struct TwinTriangle {
  std::uint32_t triangle = 0;  // index in the scene
  std::uint32_t kept = 0;      // index into CleanTriangles::kept
  bool is_opposite = false;    // the two face opposite ways
};

struct CleanTriangles {
  std::vector<CleanTriangle> kept;
  std::vector<std::uint32_t> without_area;  // indices in the scene
  std::vector<TwinTriangle> twins;
};

// Returns the scene's opaque triangles in file order, without those that have no area (no more height than
// the rounding of their coordinates) and without duplicates: of triangles in exactly the same place the lamp
// stays, else the first. Triangles left out are counted in warnings.
CleanTriangles clean_triangles(const Scene& scene, VertexWeld& weld, const Context& context = {});

}  // namespace luxel
