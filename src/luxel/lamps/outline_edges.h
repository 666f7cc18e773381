// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/core/none.h"
#include "luxel/core/vector.h"
#include "luxel/patch/patch_set.h"
#include "luxel/patch/vertex_triangles.h"
#include "luxel/scene/point_light.h"

namespace luxel {

// An edge of a triangle at which the surface ends as seen from a point or a sun: the light passes it on one
// side.
struct OutlineEdge {
  Vec3d a{0.0}, b{0.0};  // m
  Vec3d outward{0.0};    // unit, at right angles to the edge and to the light: away from the surface
  std::array<std::uint32_t, 2> corners{};  // vertices of a and b
  // A number of the lamp, and of where its penumbra begins or ends; none: the shadow is hard.
  std::uint32_t penumbra = none;
  double spread = 0.0;  // rad, about the edge, by which the light spreads: its penumbra; 0: hard
  double weight = 0.0;  // length across the light (m) times irradiance at normal incidence (W/m², of the
                        // bands together)
};

// Finds the edges of the outline: all triangles at such an edge lie on the same side of the plane through the
// edge and the light. Boundary edges, edges between a face towards the light and one away from it, and folds.
// Edges of no irradiance are left out. In the order of triangles, each edge once. The same for any number of
// threads.
//
// triangles: PatchSet::corners, with their neighbours. Cost: about 0.1 us per triangle.
std::vector<OutlineEdge> find_outline_edges(const PatchSet& triangles, const VertexTriangles& neighbours,
                                            const BandPointLight& light, const Context& context);

}  // namespace luxel
