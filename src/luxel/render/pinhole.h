// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "luxel/core/vector.h"
#include "luxel/scene/camera.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// The rays of a pinhole camera through the pixels of a picture. Pixels are square. Only IEEE-exact
// operations, so every host shoots the same rays.
class Pinhole {
 public:
  // Throws InputError for a camera that sees nothing definite (a number that is not finite, eye and target
  // at one place, up along the view, a field of view outside (0, 180)) or sides outside 1 to 32768.
  Pinhole(const Camera& camera, int width, int height);

  // x in [0, width] from the left, y in [0, height] from the top; the middle of the top left pixel is (0.5,
  // 0.5).
  Ray ray(double x, double y) const;
  // A ray at random in each cell of a grid of side x side over the pixel in column x and row y. No two of the
  // side² rays lie in the same of side² columns, or rows, so that upright and level edges are smooth
  // (correlated multi-jittered sampling; Kensler 2013). key: of the pixel, see address.h; cell: 0 to side² -
  // 1, by rows.
  Ray ray_in_cell(double x, double y, std::uint64_t key, int cell, int side) const;

 private:
  Vec3 eye_;
  Vec3d corner_;        // from the eye to the picture's top left corner, in a plane at distance 1
  Vec3d right_, down_;  // one pixel
};

// Tangent of an angle in degrees, in (0, 90).
double tangent_of_degrees(double degrees);

// The unit vector at this share of a full turn, any number, counted from x towards y.
Vec2 on_circle(float turn);

}  // namespace luxel
