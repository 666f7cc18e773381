// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "luxel/patch/vertex_weld.h"
#include "luxel/report/log.h"
#include "luxel/scene/scene.h"

namespace luxel {

// Whether a triangle has a plane that floats can tell: more height than half a unit in the last place of its
// largest coordinate. With less, what is left is rounding, and so is its normal.
bool has_area(const Vec3& a, const Vec3& b, const Vec3& c);

// An input triangle that carries light.
struct CleanTriangle {
  std::array<std::uint32_t, 3> corners;  // into the weld
  std::uint32_t triangle = 0;            // index in the scene
  bool opposite_twin = false;            // another triangle lay on it, facing the other way
};

// The scene's opaque triangles without those that have no area (no more height than the rounding of their
// coordinates) and without those that lie exactly on another one: of each such pile the lamp stays, else the
// first. What is left out is counted in warnings. In file order.
std::vector<CleanTriangle> clean_triangles(const Scene& scene, VertexWeld& weld, const LogSink& log);

}  // namespace luxel
