// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "luxel/patch/vertex_weld.h"
#include "luxel/report/log.h"
#include "luxel/scene/scene.h"

namespace luxel {

// An input triangle that carries light.
struct CleanTriangle {
  std::array<std::uint32_t, 3> corners;  // into the weld
  std::uint32_t triangle = 0;            // index in the scene
  bool opposite_twin = false;            // another triangle lay on it, facing the other way
};

// The scene's triangles without those that have no area (no more height than the rounding of their
// coordinates) and without those that lie exactly on another one: of each such pile the lamp stays, else the
// first. What is left out is counted in warnings. In file order.
std::vector<CleanTriangle> clean_triangles(const Scene& scene, VertexWeld& weld, const LogSink& log);

}  // namespace luxel
