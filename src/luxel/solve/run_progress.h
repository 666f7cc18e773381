// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>

#include "luxel/core/progress.h"
#include "luxel/core/ranks.h"
#include "luxel/solve/round_plan.h"
#include "luxel/solve/sampled.h"
#include "luxel/solve/time_forecast.h"

namespace luxel {

// What a sampled run reports while it works: the caller's monitor, the run's clock, and its forecast of time,
// which Progress::done comes from.
class RunProgress {
 public:
  // Keeps references to options and monitor. ranks: of several processes, or nothing. is_resumed: the run
  // goes on from samples of an earlier one.
  RunProgress(const SampledOptions& options, const Monitor& monitor, const Ranks* ranks, bool is_resumed);

  double elapsed() const;         // s since it was made
  double agreed_elapsed() const;  // that of the first rank, for decisions

  // In their order, round by round. error: stated, and with what may be wrong with it; cost: of all samples.
  void begin_answer();
  void end_answer(double error, double safe_error, double cost, std::uint64_t rays);
  void begin_round(const RoundPlan& plan);

  // Reports what there is of the light, with the fraction of the run's time that has passed.
  Next report(std::uint64_t rays, const Solution* light = nullptr);
  Next report(const Progress& progress);
  // Of several ranks all, or none: they must stop together, when the first one was asked to. Between answers.
  bool is_stopped(Next next) const;

 private:
  using Clock = std::chrono::steady_clock;

  double worked() const { return elapsed() - monitor_seconds_; }

  const Monitor& monitor_;
  const Ranks* ranks_;
  Clock::time_point begin_ = Clock::now();
  // Inside the monitor, where a program may hold the run: no time of the forecast.
  double monitor_seconds_ = 0.0;
  bool is_stop_asked_ = false;  // of several ranks
  TimeForecast forecast_;
  double error_ = 0.0;
};

}  // namespace luxel
