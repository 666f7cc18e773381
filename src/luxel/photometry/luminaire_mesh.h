// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "luxel/photometry/photometry.h"

namespace luxel {

// A mesh in a luminaire's local axes, m.
struct LuminaireMesh {
  std::vector<Vec3> positions;
  std::vector<Vec3> normals;                            // [position], unit, outwards
  std::vector<std::array<std::uint32_t, 3>> triangles;  // counter-clockwise seen from outside
};

// The opening as displays show it: a point becomes a sphere of 4 cm, so that it is seen.
LuminousOpening shown_opening(const LuminousOpening& opening);

// The surface of an opening. A flat one is one sheet whose normal is the aim, -Z (a vertical disk: its axis).
// steps: into how many parts an edge of a flat face is cut, above 0. A point has no mesh.
LuminaireMesh opening_mesh(const LuminousOpening& opening, int steps = 1);

// The photometric solid: luminous intensity relative to the largest by direction, on a grid of angles.
// Vertical angles run from the aim (gamma 0, local -Z) to the opposite, horizontal ones around from local +X
// towards +Y.
struct PhotometricSolid {
  static constexpr std::size_t rows = 73, columns = 24;  // every 2.5 and 15 degrees

  std::vector<float> radius;  // [row * columns + column], 0 to 1

  // Unit, in local axes. column: may be `columns`, which is column 0 again.
  static Vec3d direction(std::size_t row, std::size_t column);
  // A point of the solid whose largest radius is 1.
  Vec3d point(std::size_t row, std::size_t column) const {
    return static_cast<double>(radius[row * columns + column % columns]) * direction(row, column);
  }
};

// Costs 90 µs.
PhotometricSolid photometric_solid(const IntensityDistribution& intensity);

}  // namespace luxel
