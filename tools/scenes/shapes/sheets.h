// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "scenes/shapes/mesh.h"

namespace luxel::scenes {

// A bent sheet of columns x rows cells over (s, t) in [0, 1]², open at its border. Its front is where
// d/ds x d/dt points.
Mesh sheet(int columns, int rows, const std::function<Vec3d(double s, double t)>& point);

// A flat panel origin + a u + b v, cut along the given values of a and b (at least two each, rising), without
// the cells whose middle skip names. Its front is where u x v points.
using Skip = std::function<bool(double a, double b)>;
Mesh panel(const Vec3d& origin, const Vec3d& u, const Vec3d& v, const std::vector<double>& a,
           const std::vector<double>& b, const Skip& skip = {});

// A flat disc in the plane z = 0, facing +z; with an inner radius a ring; from and to: its sector in degrees,
// counter-clockwise from +x.
Mesh disc(double radius, double inner_radius = 0.0, double from = 0.0, double to = 360.0, int segments = 32);

// From stop to stop (at least two, rising) in equal steps of at most the given length.
std::vector<double> steps(const std::vector<double>& stops, double longest);

}  // namespace luxel::scenes
