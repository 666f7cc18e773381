// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "luxel/core/vector.h"
#include "luxel/lamps/lamps.h"

namespace luxel {

// A lamp that may light one side of a patch.
struct SideLamp {
  std::uint32_t lamp = 0;
  double irradiance = 0.0;  // W/m² at unit radiance, nothing between; mean over the patch
  // Bound of the error of a first value and of the rule of three points, W/m² summed over bands.
  double error = 0.0, three_point = 0.0;
};

// Finds the candidates that light some part of the triangle `corners` with unit normal n, ignoring occlusion:
// those with a part above its horizon, and with a part of it before them. Each has its mean over the
// triangle, so that their sum (weighted by radiance) is right to about 1e-3 RMS over sides: two terms of a
// series where a lamp is far or matters little, its closed form at three points or many where it is near.
// mean = false: a rough value, for choosing. Costs about 50 ns per lamp, and 0.4 us or more for one that is
// near and matters. found: cleared first; reuse it between calls to avoid allocation.
void find_side_lamps(const Lamps& lamps, std::span<const std::uint32_t> candidates,
                     const std::array<Vec3, 3>& corners, const Vec3& n, bool mean,
                     std::vector<SideLamp>& found);

}  // namespace luxel
