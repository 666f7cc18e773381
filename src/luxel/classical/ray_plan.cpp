// SPDX-License-Identifier: Apache-2.0
#include "luxel/classical/ray_plan.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "luxel/patch/side.h"

namespace luxel {
namespace {

constexpr std::size_t grain = 8192;  // sides per chunk

}  // namespace

std::size_t RayPlan::entry_of_ray(std::uint64_t ray) const {
  return static_cast<std::size_t>(std::upper_bound(first_ray.begin(), first_ray.end(), ray) -
                                  first_ray.begin() - 1);
}

void RayPlan::write_quantum(std::span<const double> watts, std::span<std::int64_t> quantum_of_band) const {
  const auto whole = std::accumulate(watts.begin(), watts.end(), 0.0);
  for (std::size_t b = 0; b < watts.size(); ++b)
    quantum_of_band[b] = whole > 0.0 ? scale.units(quantum * (watts[b] / whole)) : 0;
}

RayPlan make_ray_plan(const SidePower& leaving, std::size_t bands, std::uint64_t rays, double offset,
                      const Context& context) {
  const auto entries = leaving.side.size();
  const auto sides = entries > 0 ? std::size_t{leaving.side.back().index()} + 1 : 0;
  const auto power = [&](std::size_t e) {
    return std::accumulate(&leaving.watts[e * bands], &leaving.watts[e * bands] + bands, 0.0);
  };
  // 1. The running sum at the beginning of each chunk, added in order.
  std::vector<double> sum_before((sides + grain - 1) / grain + 1, 0.0);
  context.for_chunks(sides, grain, [&](std::size_t begin, std::size_t end, int) {
    const auto range = entries_between(leaving.side, SideId::at(begin), SideId::at(end));
    double sum = 0.0;
    for (auto e = range.begin; e < range.end; ++e) sum += power(e);
    sum_before[begin / grain + 1] = sum;
  });
  std::partial_sum(sum_before.begin(), sum_before.end(), sum_before.begin());
  const auto total = sum_before.back();

  RayPlan plan;
  plan.rays = total > 0.0 ? rays : 0;
  plan.scale = FixedPoint::for_sum(total);
  plan.first_ray.assign(entries + 1, plan.rays);
  if (plan.rays == 0) return plan;
  const auto n = static_cast<double>(plan.rays);
  plan.quantum = total / n;

  // 2. The last ray of each side. A side at the beginning of a chunk is reached by two sums whose last bits
  // may differ. Only the side before it writes its first_ray, so the plan has no gap.
  plan.first_ray[0] = 0;
  context.for_chunks(sides, grain, [&](std::size_t begin, std::size_t end, int) {
    const auto range = entries_between(leaving.side, SideId::at(begin), SideId::at(end));
    double sum = sum_before[begin / grain];
    for (auto e = range.begin; e < range.end; ++e) {
      sum = e + 1 == range.end ? sum_before[begin / grain + 1] : sum + power(e);
      const auto last = std::clamp(std::ceil(n * (sum / total) - offset), 0.0, n);
      plan.first_ray[e + 1] = static_cast<std::uint64_t>(last);
    }
  });
  // 3. Rounding may lower the sum by a bit, which must not reduce the number of rays. A ray left over at the
  // end goes to the last side with power.
  for (std::size_t e = 0; e < entries; ++e)
    plan.first_ray[e + 1] = std::max(plan.first_ray[e], plan.first_ray[e + 1]);
  for (auto e = entries; e > 0 && plan.first_ray[e] < plan.rays; --e) {
    plan.first_ray[e] = plan.rays;
    if (power(e - 1) > 0.0) break;
  }
  return plan;
}

}  // namespace luxel
