// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "luxel/lighting/coefficients.h"

#include "support/truth_scenes.h"

namespace luxel::truth {

// Ground that hides nothing of the sky.
inline Scene open_ground() {
  SceneBuilder builder;
  builder.material("ground", 0.5f, 0.0f).quad({-9, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-9, 9, 0});
  return builder.scene();
}

// Coefficients of `points` points in two equal replicates, of which the first has this part of the whole
// sky's light, straight from the sky, and the others none.
inline DaylightCoefficients open_sky(std::size_t points, float part = 1.0f) {
  DaylightCoefficients c;
  c.sky = SkyPatches(1, {0, 0, 1}, {0, 1, 0});
  c.points = points;
  c.replicates = 2;
  for (auto& path : c.of) path.assign(2 * points * c.sky.size(), 0.0f);
  for (std::size_t r = 0; r < 2; ++r)
    for (std::size_t p = 1; p < c.sky.size(); ++p)
      c.of[0][r * c.sky.size() + p] = part * static_cast<float>(c.sky.projected_solid_angle(p));
  return c;
}

}  // namespace luxel::truth
