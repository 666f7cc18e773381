// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/round_plan.h"

#include "luxel/solve/sample_units.h"

namespace luxel {
namespace {

constexpr double growth_to_error = 3.0;
constexpr double growth_to_bound = 1.0;

}  // namespace

double max_growth(const SampledOptions& options) {
  return options.rays > 0 || options.seconds > 0.0 ? growth_to_bound : growth_to_error;
}

RoundPlan plan_round(std::span<const SampleUnit> units, std::size_t direct_units, double aimed_squared_error,
                     const SampledOptions& options) {
  RoundPlan plan;
  for (const auto& u : units) plan.cost += u.cost;
  plan.doublings =
      plan_doublings(units, aimed_squared_error, min_growth * plan.cost, max_growth(options) * plan.cost);
  for (std::size_t u = 0; u < units.size(); ++u) {
    const auto cost = units[u].cost * ((1 << plan.doublings[u]) - 1);
    plan.more_cost += cost;
    plan.more_rays += u < direct_units ? cost / shadow_ray_cost : cost;
  }
  plan.squared_error = expected_squared_error(units, plan.doublings);
  return plan;
}

std::optional<StopReason> broken_bound(const RoundPlan& plan, const SampledOptions& options,
                                       std::uint64_t rays, double seconds) {
  if (options.rays > 0 && static_cast<double>(rays) + plan.more_rays > static_cast<double>(options.rays))
    return StopReason::ray_limit;
  if (options.seconds > 0.0 && seconds * (1.0 + plan.more_cost / plan.cost) > options.seconds)
    return StopReason::time_limit;
  return {};
}

}  // namespace luxel
