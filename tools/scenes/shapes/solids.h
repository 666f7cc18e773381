// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scenes/shapes/mesh.h"

namespace luxel::scenes {

// All closed, faces outwards. Boxes stand on y = 0, centred in x and z. Lengths in metres.

Mesh box(const Vec3d& size);

// A box whose faces are cut along the given values of x and z (rising, at least two each), to be painted.
Mesh cut_box(const std::vector<double>& x, double height, const std::vector<double>& z);

// A box whose edges are quarter rounds of four facets. cells: how often its flat parts are divided along each
// axis, for deformations to come. radius: at most half the smallest side.
Mesh rounded_box(const Vec3d& size, double radius, const glm::ivec3& cells = {1, 1, 1});

// A box whose edges and corners are cut off by flat chamfers of this width: 44 triangles.
Mesh chamfered_box(const Vec3d& size, double chamfer);

// A seat cushion: a rounded box whose top swells by puff.
Mesh cushion(const Vec3d& size, double radius, double puff);

// A pillow in the plane z = 0, centred at the origin: swollen in the middle, with drawn-out corners.
Mesh pillow(double width, double height, double thickness);

// A convex outline in the plane z = 0, counter-clockwise seen from +z, pulled along +z.
Mesh prism(const std::vector<glm::dvec2>& outline, double depth);

}  // namespace luxel::scenes
