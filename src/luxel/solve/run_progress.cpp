// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/run_progress.h"

#include <algorithm>

namespace luxel {
namespace {

TimeForecastOptions forecast_options(const SampledOptions& options, bool is_resumed) {
  return {.error = options.error,
          .aim = aim,
          .rays = static_cast<double>(options.rays),
          .seconds = options.seconds,
          .min_growth = min_growth,
          .max_growth = max_growth(options),
          .is_resumed = is_resumed};
}

}  // namespace

RunProgress::RunProgress(const SampledOptions& options, const Monitor& monitor, const Ranks* ranks,
                         bool is_resumed)
    : monitor_(monitor), ranks_(ranks), forecast_(forecast_options(options, is_resumed)) {}

double RunProgress::elapsed() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }

double RunProgress::agreed_elapsed() const { return agreed(ranks_, elapsed()); }

void RunProgress::begin_answer() { forecast_.begin_answer(worked()); }

void RunProgress::end_answer(double error, double safe_error, double cost, std::uint64_t rays) {
  error_ = error;
  forecast_.end_answer(worked(), safe_error, cost, static_cast<double>(rays));
}

void RunProgress::begin_round(const RoundPlan& plan) {
  forecast_.begin_round(worked(), {plan.more_cost, plan.more_rays, plan.squared_error});
}

Next RunProgress::report(std::uint64_t rays, const Solution* light) {
  return report({"light", forecast_.done(worked(), static_cast<double>(rays)), rays, error_, light});
}

Next RunProgress::report(const Progress& progress) {
  const auto begin = elapsed();
  const auto next = tell(monitor_, progress);
  monitor_seconds_ += elapsed() - begin;
  if (!ranks_) return next;
  is_stop_asked_ |= next == Next::stop;
  return Next::go_on;
}

bool RunProgress::is_stopped(Next next) const { return agreed(ranks_, next == Next::stop || is_stop_asked_); }

}  // namespace luxel
