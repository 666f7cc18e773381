// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "luxel/parallel/workers.h"
#include "luxel/transport/fixed_point.h"

namespace luxel {

// Who shoots how much: rays are numbered 0 to rays - 1, and side s shoots [first_ray[s], first_ray[s + 1]).
// Every ray carries the same power, summed over bands; the bands of its side share it.
struct RayPlan {
  std::vector<std::uint64_t> first_ray;  // [side + 1]
  std::vector<std::int64_t> quantum;     // [side][band]: what one ray of the side carries, in units of scale
  FixedPoint scale;
  std::uint64_t rays = 0;  // none where nothing leaves

  // The side that shoots this ray. O(log sides).
  std::size_t side_of_ray(std::uint64_t ray) const;
};

// Rays in proportion to power by systematic sampling (Madow and Madow 1944): ray k belongs to the side whose
// stretch of the running sum holds (k + offset) / rays. So a side gets its fair number of rays rounded down
// or up, and on average exactly that. leaving: W, [side][band]; offset in [0, 1). The same plan on any number
// of threads.
RayPlan make_ray_plan(std::span<const double> leaving, std::size_t bands, std::uint64_t rays, double offset,
                      const Workers& workers);

}  // namespace luxel
