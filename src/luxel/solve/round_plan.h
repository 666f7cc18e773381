// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "luxel/solution/solution.h"
#include "luxel/solve/sample_plan.h"
#include "luxel/solve/sampled.h"

namespace luxel {

constexpr double aim = 0.9;  // of the squared error asked for: another round costs more than that
// A round costs at least so many times all before it: who looks often stops at the first lucky estimate.
constexpr double min_growth = 0.5;

// A round costs at most so many times all before it: less where rays or time may end the run, not too far
// from there. The samples that are taken do not depend on where a bound is, so that a longer run goes the
// same way.
double max_growth(const SampledOptions& options);

// The samples that the next round takes.
struct RoundPlan {
  std::vector<std::uint8_t> doublings;  // [unit], see plan_doublings()
  double cost = 0.0;                    // of all samples before
  double more_cost = 0.0;               // of the round
  double more_rays = 0.0;               // likewise
  double squared_error = 0.0;           // squared error that is left, as the plan expects it

  bool is_empty() const { return more_cost == 0.0; }
};

// direct_units: that come first, of shadow rays. aimed_squared_error: of all units together.
RoundPlan plan_round(std::span<const SampleUnit> units, std::size_t direct_units, double aimed_squared_error,
                     const SampledOptions& options);

// The bound of rays or time that the round would break, if any, after so many rays and seconds.
std::optional<StopReason> broken_bound(const RoundPlan& plan, const SampledOptions& options,
                                       std::uint64_t rays, double seconds);

}  // namespace luxel
