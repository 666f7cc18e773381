// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "luxel/math/vector.h"
#include "luxel/transport/lamps.h"

namespace luxel {

// A lamp that may light one side of a patch.
struct SideLamp {
  std::uint32_t lamp = 0;
  double irradiance = 0.0;  // W/m² at unit radiance, nothing between; mean over the patch
};

// Those of the candidates that shine on some of the triangle `corners` with unit normal n, if nothing stands
// between: with a part above its horizon, and with a part of it before them. Each with its closed form
// averaged over the triangle, to about 1e-3 of the sum over lamps (weighted by radiance): one point where the
// lamps are far, more where they are near. mean = false: at the centroid alone. Costs about 0.1 us a lamp,
// several where it is near.
void find_side_lamps(const Lamps& lamps, std::span<const std::uint32_t> candidates,
                     const std::array<Vec3, 3>& corners, const Vec3& n, bool mean,
                     std::vector<SideLamp>& found);

}  // namespace luxel
