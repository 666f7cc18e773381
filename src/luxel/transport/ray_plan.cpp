// SPDX-License-Identifier: Apache-2.0
#include "luxel/transport/ray_plan.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace luxel {

std::size_t RayPlan::side_of_ray(std::uint64_t ray) const {
  return static_cast<std::size_t>(std::upper_bound(first_ray.begin(), first_ray.end(), ray) -
                                  first_ray.begin() - 1);
}

RayPlan make_ray_plan(std::span<const double> leaving, std::size_t bands, std::uint64_t rays, double offset) {
  const auto sides = leaving.size() / bands;
  const auto power = [&](std::size_t side) {
    return std::accumulate(&leaving[side * bands], &leaving[side * bands] + bands, 0.0);
  };
  double total = 0.0;
  for (std::size_t s = 0; s < sides; ++s) total += power(s);

  RayPlan plan;
  plan.rays = total > 0.0 ? rays : 0;
  plan.scale = FixedPoint::for_sum(total);
  plan.first_ray.assign(sides + 1, plan.rays);
  plan.quantum.assign(leaving.size(), 0);
  if (plan.rays == 0) return plan;

  const auto n = static_cast<double>(plan.rays);
  double sum = 0.0;
  plan.first_ray[0] = 0;
  for (std::size_t s = 0; s < sides; ++s) {
    const auto own = power(s);
    sum += own;
    const auto end = std::clamp(std::ceil(n * (sum / total) - offset), 0.0, n);
    plan.first_ray[s + 1] = std::max(plan.first_ray[s], static_cast<std::uint64_t>(end));
    for (std::size_t b = 0; b < bands && own > 0.0; ++b)
      plan.quantum[s * bands + b] = plan.scale.units(total / n * (leaving[s * bands + b] / own));
  }
  // Rounding of the running sum may leave the last ray without an owner: it goes to the last side that
  // shines.
  for (auto s = sides; s > 0 && plan.first_ray[s] < plan.rays; --s) {
    plan.first_ray[s] = plan.rays;
    if (power(s - 1) > 0.0) break;
  }
  return plan;
}

}  // namespace luxel
