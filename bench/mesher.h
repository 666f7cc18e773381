// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include "luxel/scene/scene.h"

namespace luxel::bench {

// Builds a scene out of quads, each cut in a regular grid of cells about `cell` metres wide, two triangles a
// cell. How an edge is cut depends on its own two ends only, so quads that share a whole edge fit together.
class Mesher {
 public:
  static constexpr float uncut = std::numeric_limits<float>::infinity();

  explicit Mesher(float cell = uncut) : cell_(cell) {}

  // Sets the material of further faces. emittance: W/m² per band.
  void material(const char* name, const Vec3& reflectance, const Vec3& emittance = Vec3(0.0f));
  // Counter-clockwise seen from the front.
  void quad(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
  // Two triangles, whatever the cell.
  void whole_quad(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
  // Six faces; outwards, or inwards for a room.
  void box(const Vec3& low, const Vec3& high, bool inwards = false);

  Scene take();

 private:
  void grid(const std::array<Vec3, 4>& corners, int columns, int rows);

  float cell_;
  Scene scene_;
};

}  // namespace luxel::bench
