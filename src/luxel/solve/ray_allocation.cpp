// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/ray_allocation.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <queue>
#include <tuple>

#include "luxel/solve/tuning.h"

namespace luxel {

namespace {

using namespace tuning::doublings;

}  // namespace

std::vector<std::uint8_t> plan_doublings(std::span<const SampleUnit> units, double target, double least,
                                         double budget) {
  std::vector<std::uint8_t> doublings(units.size(), 0);
  using Entry = std::tuple<double, std::size_t>;  // squared_error over cost, unit
  std::priority_queue<Entry> queue;
  double squared_error = 0.0;
  for (std::size_t u = 0; u < units.size(); ++u) {
    squared_error += units[u].squared_error;
    if (units[u].squared_error > 0.0) queue.emplace(units[u].squared_error / units[u].cost, u);
  }
  double spent = 0.0;
  while ((squared_error > target || spent < least) && !queue.empty()) {
    const auto [worth, u] = queue.top();
    queue.pop();
    if (doublings[u] == max_doublings) {
      // The remainder is smaller than this unit, whose error will be known better next time.
      if (spent >= least) break;
      continue;
    }
    double left = units[u].squared_error;
    double cost = units[u].cost;
    for (int i = 0; i < doublings[u]; ++i) {
      left *= left_by_doubling;
      cost *= 2.0;
    }
    if (spent + cost > budget) break;
    spent += cost;
    squared_error -= (1.0 - left_by_doubling) * left;
    ++doublings[u];
    queue.emplace(worth * 0.5 * left_by_doubling, u);
  }
  return doublings;
}

double expected_squared_error(std::span<const SampleUnit> units, std::span<const std::uint8_t> doublings) {
  double sum = 0.0;
  for (std::size_t u = 0; u < units.size(); ++u)
    sum += units[u].squared_error * std::pow(left_by_doubling, doublings[u]);
  return sum;
}

namespace {

using namespace tuning::rounds;

}  // namespace

double max_growth(const SampledOptions& options, bool is_after_first) {
  if (options.rays > 0 || options.seconds > 0.0) return growth_to_bound;
  return is_after_first ? growth_after_first : growth_later;
}

double growth_to_target(double squared_error, double target, bool is_after_first, double max_growth) {
  const auto exponent = is_after_first ? first_exponent : later_exponent;
  const auto needed = target > 0.0 ? std::pow(squared_error / target, 1.0 / exponent) - 1.0 : max_growth;
  return std::clamp(needed, min_growth, std::max(min_growth, max_growth));
}

RoundPlan plan_round(std::span<const SampleUnit> units, const RoundStart& start,
                     const SampledOptions& options) {
  RoundPlan plan;
  for (const auto& u : units) plan.cost += u.cost;
  const auto most = max_growth(options, start.is_after_first);
  const auto least = options.error > 0.0 ? growth_to_target(start.squared_error, start.aimed_squared_error,
                                                            start.is_after_first, most)
                                         : min_growth;
  plan.doublings = plan_doublings(units, start.aimed_squared_error, least * plan.cost, most * plan.cost);
  if (start.is_after_first && !(start.squared_error > 0.0)) plan.doublings.assign(units.size(), 1);
  for (std::size_t u = 0; u < units.size(); ++u) {
    const auto cost = units[u].cost * ((1 << plan.doublings[u]) - 1);
    plan.more_cost += cost;
    plan.more_rays += u < start.direct_units ? cost / tuning::units::shadow_ray_cost : cost;
  }
  plan.squared_error = expected_squared_error(units, plan.doublings);
  return plan;
}

bool is_beyond_budget(double now, double next, double budget) {
  return budget > 0.0 && std::sqrt(now * next) > budget;
}

std::optional<StopReason> broken_bound(const RoundPlan& plan, const SampledOptions& options,
                                       std::uint64_t rays, double seconds) {
  const auto now = static_cast<double>(rays), next = now + plan.more_rays;
  if ((options.rays > 0 && next > static_cast<double>(options.rays)) ||
      is_beyond_budget(now, next, static_cast<double>(options.ray_budget)))
    return StopReason::ray_limit;
  if (options.seconds > 0.0 && seconds * (1.0 + plan.more_cost / plan.cost) > options.seconds)
    return StopReason::time_limit;
  return {};
}

namespace {

using namespace tuning::units;

}  // namespace

std::vector<SampleUnit> make_sample_units(const Sampling& sampling, std::uint32_t replicates,
                                          std::span<const double> importance,
                                          std::span<const double> direct_squared_error,
                                          std::span<const double> gathered_squared_error, double whole) {
  const auto begins = sampling.units();
  const auto n = begins.size() - 1;
  std::vector<SampleUnit> units(n + gathered_squared_error.size());
  for (std::size_t u = 0; u < n; ++u) {
    const auto count = begins[u + 1] - begins[u];
    units[u] = {
        weighted_sum(importance.subspan(begins[u], count), direct_squared_error.subspan(begins[u], count)),
        shadow_ray_cost * sampling.direct().samples_per_receiver()[begins[u]] * replicates * count};
  }
  for (std::size_t s = 0; s < gathered_squared_error.size(); ++s)
    units[n + s] = {gathered_squared_error[s],
                    static_cast<double>(sampling.hits().rays_per_receiver()[s]) * replicates};
  double sum = 0.0;
  for (const auto& u : units) sum += u.squared_error;
  for (auto& u : units) u.squared_error *= whole / std::max(sum, 1e-300);
  return units;
}

double cost_of_samples(const Sampling& sampling, std::uint32_t replicates) {
  const auto sum = [](std::span<const std::uint32_t> counts) {
    return static_cast<double>(std::accumulate(counts.begin(), counts.end(), std::uint64_t{0}));
  };
  return replicates * (shadow_ray_cost * sum(sampling.direct().samples_per_receiver()) +
                       sum(sampling.hits().rays_per_receiver()));
}

std::vector<double> importance_of_own_noise(std::span<const std::uint32_t> begins,
                                            std::span<const double> importance,
                                            std::span<const double> own_squared_error,
                                            std::span<const double> smoothed_squared_error) {
  assert(own_squared_error.size() == importance.size());
  assert(smoothed_squared_error.size() == importance.size());
  std::vector<double> result(importance.begin(), importance.end());
  for (std::size_t u = 0; u + 1 < begins.size(); ++u) {
    double own = 0.0;
    double smoothed = 0.0;
    for (auto s = begins[u]; s < begins[u + 1]; ++s) {
      own += importance[s] * own_squared_error[s];
      smoothed += importance[s] * smoothed_squared_error[s];
    }
    const auto left = own > 0.0 ? std::clamp(smoothed / own, min_noise_left, 1.0) : 1.0;
    for (auto s = begins[u]; s < begins[u + 1]; ++s) result[s] *= left;
  }
  return result;
}

double weighted_sum(std::span<const double> weights, std::span<const double> values) {
  assert(weights.size() == values.size());
  return std::inner_product(weights.begin(), weights.end(), values.begin(), 0.0);
}

namespace {

using namespace tuning::gathered;

// Calls body(first receiver, end receiver) for each unit.
template <typename Body>
void for_units(std::span<const std::uint32_t> begins, const Context& context, Body body) {
  context.for_chunks(begins.size() - 1, 64, [&](std::size_t first, std::size_t end, int) {
    for (auto u = first; u < end; ++u) body(begins[u], begins[u + 1]);
  });
}

}  // namespace

std::vector<double> gather_errors(const PatchSet& patches, const SampledOperator& transport,
                                  const GatherErrorInput& input, const Context& context) {
  assert(input.importance.size() == transport.sides().size());
  assert(input.gathered.size() == transport.sides().size() * patches.band_count());
  const auto begins = input.begins;
  const auto importance = input.importance;
  const auto radiosity = input.radiosity, gathered = input.gathered;
  const auto receivers = transport.sides().size();
  const auto bands = patches.band_count();
  const auto area = [&](std::size_t s) {
    return static_cast<double>(patches.area[transport.sides().side[s].patch()]);
  };

  // 1. Gathered light of rows, averaged over each unit; and radiosities, the mean of both halves.
  std::vector<float> level(receivers * bands);
  for_units(begins, context, [&](std::size_t first, std::size_t end) {
    for (std::size_t b = 0; b < bands; ++b) {
      double sum = 0.0;
      double areas = 0.0;
      for (auto s = first; s < end; ++s) {
        sum += area(s) * static_cast<double>(gathered[s * bands + b]);
        areas += area(s);
      }
      for (auto s = first; s < end; ++s) level[s * bands + b] = static_cast<float>(sum / areas);
    }
  });
  const CrossedHalves crossed(transport, bands);
  auto seen = crossed.seen_by(0, radiosity);
  const auto other = crossed.seen_by(1, radiosity);
  for (std::size_t i = 0; i < seen.size(); ++i) seen[i] = 0.5f * (seen[i] + other[i]);

  // 2. The value of a ray. Neighbours use the mean, with their own importance and number of rays: the
  // estimate of a single row is noisy, and a side that often met a bright one by chance would get more rays,
  // which dilute that chance, while a side that met it too seldom would get none.
  auto worth = transport.ray_worth(importance, seen, level, context);
  const auto rays = [&](std::size_t s) {
    return static_cast<double>(transport.hits().rays_per_receiver()[s]);
  };
  for_units(begins, context, [&](std::size_t first, std::size_t end) {
    double own = 0.0, own_areas = 0.0;
    double given = 0.0, areas = 0.0;
    for (auto s = first; s < end; ++s) {
      given += area(s) * static_cast<double>(worth.given[s]);
      areas += area(s);
      if (!(importance[s] > 0.0)) continue;
      own += area(s) * static_cast<double>(worth.own[s]) / importance[s] * rays(s) * rays(s);
      own_areas += area(s);
    }
    for (auto s = first; s < end; ++s) {
      worth.own[s] =
          own_areas > 0.0 ? static_cast<float>(own / own_areas * importance[s] / (rays(s) * rays(s))) : 0.0f;
      worth.given[s] = static_cast<float>(given / areas);
    }
  });

  // 3. Multiply by the number of rays. The variance of light that no ray has found yet is taken to be the
  // same everywhere.
  std::vector<double> squared_error(receivers);
  double sum = 0.0;
  double even_sum = 0.0;
  const auto even = [&](std::size_t s) { return area(s) * area(s) / rays(s); };
  for (std::size_t s = 0; s < receivers; ++s) {
    squared_error[s] = rays(s) * (static_cast<double>(worth.own[s]) + static_cast<double>(worth.given[s]));
    sum += squared_error[s];
    even_sum += even(s);
  }
  if (!(sum > 0.0)) return squared_error;
  for (std::size_t s = 0; s < receivers; ++s)
    squared_error[s] =
        input.whole * ((1.0 - even_part) * squared_error[s] / sum + even_part * even(s) / even_sum);
  return squared_error;
}

}  // namespace luxel
