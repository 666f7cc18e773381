// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/patch/patch_set.h"
#include "luxel/solution/solution.h"
#include "luxel/solve/sampled.h"
#include "luxel/solve/sampled_operator.h"
#include "luxel/solve/sampling.h"

namespace luxel {

// Neighbouring receivers whose samples of one kind are doubled together.
struct SampleUnit {
  double squared_error = 0.0;  // its part of the squared error
  double cost = 0.0;           // of its samples so far; the same cost again doubles them
};

// Returns how often to double each unit's samples: the largest error reductions for their cost come first,
// until the sum of squared_error is expected to be at most `target` and at least `least` is spent, or the
// next would be beyond `budget`. A doubling removes half of a unit's squared error, or a little more.
std::vector<std::uint8_t> plan_doublings(std::span<const SampleUnit> units, double target, double least,
                                         double budget);

// The sum of squared_error that is left after those doublings, as plan_doublings() expects it.
double expected_squared_error(std::span<const SampleUnit> units, std::span<const std::uint8_t> doublings);

// Bound of the cost of a round, as a multiple of all rounds before it: higher after the first answer, unless
// rays or time may end the run not far from there. The samples taken do not depend on the position of a
// limit, so that a longer run takes the same ones.
double max_growth(const SampledOptions& options, bool is_after_first);

// The samples that the next round takes.
struct RoundPlan {
  std::vector<std::uint8_t> doublings;  // [unit], see plan_doublings()
  double cost = 0.0;                    // of all samples before
  double more_cost = 0.0;               // of the round
  double more_rays = 0.0;               // of the round
  double squared_error = 0.0;           // squared error that is left, as the plan expects it

  bool is_empty() const { return more_cost == 0.0; }
};

// Cost of a round over that of all before it that is likely to bring squared_error to target, limited to what
// a round may cost.
double growth_to_target(double squared_error, double target, bool is_after_first, double max_growth);

// The state before a round, by which it is planned.
struct RoundStart {
  std::size_t direct_units = 0;      // that come first, of shadow rays
  double squared_error = 0.0;        // of all units together
  double aimed_squared_error = 0.0;  // of all units, aim of the round
  bool is_after_first = false;       // one answer has been given
};

// Estimates of single units are noisy, and those that are too high by chance are doubled first: plans
// overestimate the gain of a round. So it costs at least the amount that earlier rounds suggest, since every
// round ends with an answer that takes time. A first squared error that is not above 0 is exact light, or a
// bias that was estimated too low: then all samples are doubled.
RoundPlan plan_round(std::span<const SampleUnit> units, const RoundStart& start,
                     const SampledOptions& options);

// Returns whether an answer after `next` rays is farther from the budget than that after `now`, on a
// logarithmic scale. budget 0: never.
bool is_beyond_budget(double now, double next, double budget);

// Returns the limit of rays or time that the round would exceed, if any, after this many rays and seconds.
std::optional<StopReason> broken_bound(const RoundPlan& plan, const SampledOptions& options,
                                       std::uint64_t rays, double seconds);

// The cost of the shadow rays of each unit (first) and the gather rays of each receiver (then), and their
// parts of the squared error: importance times that of the receivers' direct light, and
// gathered_squared_error, scaled so that their sum is `whole`. All [receiver].
std::vector<SampleUnit> make_sample_units(const Sampling& sampling, std::uint32_t replicates,
                                          std::span<const double> importance,
                                          std::span<const double> direct_squared_error,
                                          std::span<const double> gathered_squared_error, double whole);

// Cost of all samples so far, that of make_sample_units() but for rounding.
double cost_of_samples(const Sampling& sampling, std::uint32_t replicates);

// The effect of a variance of 1 of each receiver's own light, before smoothing, on the error: importance
// times the part of the variance that smoothing leaves, in the mean over each unit. All [receiver]; begins:
// of units.
std::vector<double> importance_of_own_noise(std::span<const std::uint32_t> begins,
                                            std::span<const double> importance,
                                            std::span<const double> own_squared_error,
                                            std::span<const double> smoothed_squared_error);

// Sum of the products.
double weighted_sum(std::span<const double> weights, std::span<const double> values);

struct GatherErrorInput {
  std::span<const std::uint32_t> begins;  // of units of neighbouring receivers, which are taken to see alike
  std::span<const double> importance;     // I, [receiver]
  std::span<const float> radiosity;       // of CrossedHalves
  std::span<const float> gathered;        // [receiver * bands + band]
  double whole = 0.0;                     // sum of the result
};

// The part of the squared error sum of I_i Var H_i that each receiver's gather rays cause: their number times
// the benefit of one more, both to its own row and to the rows of those that it meets
// (SampledOperator::ray_worth). Doubling a receiver's rays removes about half of its part. Parts are of the
// rays' densities and the light that they see, not of what a receiver's own rays happened to find; so counts
// that follow them do not follow chance, which would bias the light.
//
// Cost: two look-ups per ray.
std::vector<double> gather_errors(const PatchSet& patches, const SampledOperator& transport,
                                  const GatherErrorInput& input, const Context& context);

}  // namespace luxel
