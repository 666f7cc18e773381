// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scenes/shapes/mesh.h"

namespace luxel::scenes {

// All closed, faces outwards.

// A round bar along a path, with flat ends. radii: one for each point of the path. The cross-section is
// carried along without twist.
Mesh tube(const std::vector<Vec3d>& path, const std::vector<double>& radii, int segments = 16);
Mesh tube(const std::vector<Vec3d>& path, double radius, int segments = 16);

// A straight leg from its foot up to its head, both cut level.
Mesh leg(const Vec3d& foot, const Vec3d& head, double foot_radius, double head_radius);

// A curve through four control points (cubic Bezier), as a path.
std::vector<Vec3d> curve(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d, int pieces);

// A rectangular frame round an opening of the given size in the plane z = 0, mitred at the corners. The
// section is a convex outline in (outwards from the opening, towards +z), counter-clockwise.
Mesh frame(double width, double height, const std::vector<glm::dvec2>& section);

}  // namespace luxel::scenes
