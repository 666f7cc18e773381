// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "luxel/classical/fixed_point.h"
#include "luxel/core/context.h"
#include "luxel/lamps/side_power.h"

namespace luxel {

// Assignment of rays to sides: rays are numbered 0 to rays - 1, and entry e of the power (SidePower) shoots
// [first_ray[e], first_ray[e + 1]). Every ray carries the same power, summed over bands; the bands of its
// side share it.
struct RayPlan {
  std::vector<std::uint64_t> first_ray;  // [entry + 1]
  FixedPoint scale;
  double quantum = 0.0;    // W per ray, all bands
  std::uint64_t rays = 0;  // none where nothing leaves

  // The entry that shoots this ray. O(log entries).
  std::size_t entry_of_ray(std::uint64_t ray) const;

  // Returns the power of one ray of a side, [band], in units of scale. watts: the side's.
  void write_quantum(std::span<const double> watts, std::span<std::int64_t> quantum_of_band) const;
};

// Rays in proportion to power by systematic sampling (Madow and Madow 1944): ray k belongs to the side whose
// interval of the running sum contains (k + offset) / rays. A side thus gets its proportional number of rays
// rounded down or up, and exactly that on average. offset in [0, 1). The same plan on any number of threads.
RayPlan make_ray_plan(const SidePower& leaving, std::size_t bands, std::uint64_t rays, double offset,
                      const Context& context);

}  // namespace luxel
