// SPDX-License-Identifier: Apache-2.0
#include "luxel/transport/ray_plan.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace luxel {
namespace {

constexpr std::size_t grain = 8192;  // sides a chunk

}  // namespace

std::size_t RayPlan::side_of_ray(std::uint64_t ray) const {
  return static_cast<std::size_t>(std::upper_bound(first_ray.begin(), first_ray.end(), ray) -
                                  first_ray.begin() - 1);
}

RayPlan make_ray_plan(std::span<const double> leaving, std::size_t bands, std::uint64_t rays, double offset,
                      const Workers& workers) {
  const auto sides = leaving.size() / bands;
  const auto power = [&](std::size_t side) {
    return std::accumulate(&leaving[side * bands], &leaving[side * bands] + bands, 0.0);
  };
  // 1. The running sum at the beginning of each chunk, added in order.
  std::vector<double> sum_before((sides + grain - 1) / grain + 1, 0.0);
  workers.for_chunks(sides, grain, [&](std::size_t begin, std::size_t end, int) {
    double sum = 0.0;
    for (auto s = begin; s < end; ++s) sum += power(s);
    sum_before[begin / grain + 1] = sum;
  });
  std::partial_sum(sum_before.begin(), sum_before.end(), sum_before.begin());
  const auto total = sum_before.back();

  RayPlan plan;
  plan.rays = total > 0.0 ? rays : 0;
  plan.scale = FixedPoint::for_sum(total);
  plan.first_ray.assign(sides + 1, plan.rays);
  plan.quantum.assign(leaving.size(), 0);
  if (plan.rays == 0) return plan;

  // 2. Each side's last ray and quantum. A side that begins a chunk is reached by two sums that may differ in
  // their last
  //    bits; first_ray of a side is written by the side before it alone, so the plan has no gap.
  const auto n = static_cast<double>(plan.rays);
  plan.first_ray[0] = 0;
  workers.for_chunks(sides, grain, [&](std::size_t begin, std::size_t end, int) {
    double sum = sum_before[begin / grain];
    for (auto s = begin; s < end; ++s) {
      const auto own = power(s);
      sum = s + 1 == end ? sum_before[begin / grain + 1] : sum + own;
      const auto last = std::clamp(std::ceil(n * (sum / total) - offset), 0.0, n);
      plan.first_ray[s + 1] = static_cast<std::uint64_t>(last);
      for (std::size_t b = 0; b < bands && own > 0.0; ++b)
        plan.quantum[s * bands + b] = plan.scale.units(total / n * (leaving[s * bands + b] / own));
    }
  });
  // 3. Rounding may have made the sum step back by a bit, which must not turn into a ray less; and the last
  // ray, left without
  //    an owner, goes to the last side that shines.
  for (std::size_t s = 0; s < sides; ++s)
    plan.first_ray[s + 1] = std::max(plan.first_ray[s], plan.first_ray[s + 1]);
  for (auto s = sides; s > 0 && plan.first_ray[s] < plan.rays; --s) {
    plan.first_ray[s] = plan.rays;
    if (power(s - 1) > 0.0) break;
  }
  return plan;
}

}  // namespace luxel
