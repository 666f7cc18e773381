// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/run_progress.h"

#include <algorithm>
#include <cmath>

#include "luxel/solve/tuning.h"

namespace luxel {

namespace {

using namespace tuning::forecast;

double steadied(double newest, double forecast) {
  return newest > 0.0 && forecast > 0.0
             ? std::pow(newest, weight_of_newest) * std::pow(forecast, 1.0 - weight_of_newest)
             : newest;
}

}  // namespace

void TimeForecast::begin_answer(double seconds) {
  if (phase_ == Phase::sampling) {
    if (plan_.cost > 0.0)
      last_sampling_ = {steadied(seconds - phase_begin_, sampling_seconds(plan_.cost)), plan_.cost};
    phase_ = Phase::answering;
  } else {
    phase_ = Phase::first_answer;
  }
  phase_begin_ = answer_begin_ = seconds;
}

void TimeForecast::end_iteration(double seconds) {
  phase_ = Phase::smoothing;
  phase_begin_ = seconds;
}

void TimeForecast::end_answer(double seconds, double error, double cost, double rays) {
  if (answers_.empty()) last_sampling_ = {second_pace * answer_begin_, cost};
  auto own = seconds - answer_begin_;
  if (phase_ == Phase::smoothing) last_smoothing_ = seconds - phase_begin_;
  if (answers_.size() >= 2) own = steadied(own, answer_seconds(cost));
  answers_.push_back({own, error * error, cost, rays});
  phase_ = Phase::planning;
  phase_begin_ = seconds;
}

void TimeForecast::begin_round(double seconds, const PlannedRound& plan) {
  answers_.back().seconds += seconds - phase_begin_;  // the plan is part of every answer
  plan_ = plan;
  phase_ = Phase::sampling;
  phase_begin_ = seconds;
}

double TimeForecast::left(double seconds, double rays) const {
  if (answers_.empty()) return -1.0;
  const auto& last = answers_.back();
  const auto count = answers_.size();
  const bool is_first = count == 1 && !options_.is_resumed;
  if (is_first && options_.error > 0.0 && options_.rays == 0.0 && options_.seconds == 0.0 &&
      last.squared_error > std::pow(max_first_error * options_.error, 2.0))
    return -1.0;
  if (is_reached(last.squared_error)) return 0.0;
  if (phase_ == Phase::planning) return -1.0;
  const auto next = planned_answer();
  const auto so_far = seconds - phase_begin_;
  double now = next.seconds;
  if (phase_ == Phase::sampling)
    now += sampling_left(seconds, rays);
  else
    now = std::max(overdue * so_far, (phase_ == Phase::smoothing ? last_smoothing_ : next.seconds) - so_far);
  return now + rounds_after(seconds + now, next, count + 1);
}

double TimeForecast::done(double seconds, double rays) {
  const auto more = left(seconds, rays);
  if (more >= 0.0 && seconds > 0.0) done_ = std::max(done_, seconds / (seconds + more));
  return done_;
}

// The pace is that of the last round, and increasingly that of the current one.
double TimeForecast::sampling_left(double seconds, double rays) const {
  const auto expected = sampling_seconds(plan_.cost);
  const auto part = plan_.rays > 0.0 ? std::clamp((rays - answers_.back().rays) / plan_.rays, 0.0, 1.0) : 0.0;
  const auto so_far = seconds - phase_begin_;
  const auto weight = std::sqrt(part);
  const auto whole = part > 0.0 ? (1.0 - weight) * expected + weight * so_far / part : expected;
  return (1.0 - part) * whole;
}

bool TimeForecast::is_bound_broken(double seconds, const Answer& last, double more_cost) const {
  const auto rays = last.rays + more_cost * rays_per_cost();
  return (options_.rays > 0.0 && rays > options_.rays) ||
         is_beyond_budget(last.rays, rays, options_.ray_budget) ||
         (options_.seconds > 0.0 && seconds * (1.0 + more_cost / last.cost) > options_.seconds);
}

double TimeForecast::rays_per_cost() const { return plan_.cost > 0.0 ? plan_.rays / plan_.cost : 1.0; }

double TimeForecast::learned_exponent() const {
  const auto n = answers_.size();
  if (n < 2) return second_exponent;
  // Over two rounds, so that one low estimate has less weight; the first round is excluded.
  const auto& from = answers_[n >= 4 ? n - 3 : n - 2];
  const auto& to = answers_.back();
  if (!(from.squared_error > 0.0 && to.squared_error > 0.0 && to.cost > from.cost)) return second_exponent;
  const auto p = std::log(from.squared_error / to.squared_error) / std::log(to.cost / from.cost);
  if (n == 2 && !options_.is_resumed) return third_exponent + weight_of_first * (p - usual_first);
  return own_part + weight_of_last * p;
}

// Cost of the next planned round over that of all before.
double TimeForecast::planned_growth(double squared_error) const {
  return growth_to_target(squared_error, options_.aim * options_.error * options_.error, false,
                          options_.max_growth);
}

double TimeForecast::sampling_seconds(double more_cost) const {
  return last_sampling_.seconds * std::pow(more_cost / last_sampling_.cost, sampling_exponent);
}

double TimeForecast::answer_seconds(double cost) const {
  const auto& last = answers_.back();
  const auto pace = last_sampling_.seconds / last_sampling_.cost;
  auto slope = answer_slope * pace;
  if (answers_.size() >= 3) {
    const auto& before = answers_[answers_.size() - 2];
    const auto learned = (last.seconds - before.seconds) / (last.cost - before.cost);
    slope = 0.5 * (slope + std::clamp(learned, 0.0, max_answer_slope * pace));
  }
  return last.seconds + slope * (cost - last.cost);
}

// answers: their number before the round.
TimeForecast::Answer TimeForecast::answer_after(const Answer& last, double more_cost,
                                                std::size_t answers) const {
  const auto cost = last.cost + more_cost;
  auto growth = cost / last.cost;
  auto squared_error = last.squared_error;
  if (answers == 1 && !options_.is_resumed) {
    const auto first_growth = std::min(growth, 1.0 + options_.min_growth);
    squared_error *= std::pow(first_growth, -first_exponent);
    growth /= first_growth;
  }
  squared_error *= std::pow(growth, -std::clamp(learned_exponent(), min_exponent, max_exponent));
  return {answer_seconds(cost), squared_error, cost, last.rays + more_cost * rays_per_cost()};
}

// Weight, 0 to 1, of another round after an answer with that predicted error.
double TimeForecast::weight_of_next(double squared_error) const {
  if (options_.error == 0.0) return 1.0;
  const auto above = std::log(squared_error / (options_.error * options_.error));
  return std::clamp((above - surely_reached) / (surely_missed - surely_reached), 0.0, 1.0);
}

TimeForecast::Answer TimeForecast::planned_answer() const {
  const auto& last = answers_.back();
  auto next = answer_after(last, plan_.cost, answers_.size());
  next.rays = last.rays + plan_.rays;
  if (plan_.squared_error > 0.0) {
    const auto believed =
        std::max(plan_excess * plan_.squared_error,
                 last.squared_error * std::pow(next.cost / last.cost, -max_believed_exponent));
    next.squared_error =
        std::pow(believed, weight_of_plan) * std::pow(next.squared_error, 1.0 - weight_of_plan);
  }
  return next;
}

// Remaining seconds from `seconds`, the time of that answer, to the end.
double TimeForecast::rounds_after(double seconds, Answer last, std::size_t answers) const {
  double sum = 0.0;
  auto weight = weight_of_next(last.squared_error);
  for (int round = 0; round < max_rounds && weight > 0.0; ++round) {
    const auto more = planned_growth(last.squared_error) * last.cost;
    if (is_bound_broken(seconds + sum, last, more)) break;
    last = answer_after(last, more, answers++);
    sum += weight * (sampling_seconds(more) + last.seconds);
    weight = std::min(weight, weight_of_next(last.squared_error));
  }
  return sum;
}

namespace {

TimeForecastOptions forecast_options(const SampledOptions& options, bool is_resumed) {
  return {.error = options.error,
          .aim = tuning::rounds::aim,
          .rays = static_cast<double>(options.rays),
          .ray_budget = static_cast<double>(options.ray_budget),
          .seconds = options.seconds,
          .min_growth = tuning::rounds::min_growth,
          .max_growth = max_growth(options, false),
          .is_resumed = is_resumed};
}

}  // namespace

RunProgress::RunProgress(const SampledOptions& options, const SolveHooks& hooks, const Context& context)
    : on_light_(hooks.on_light),
      context_(context),
      work_(context),
      forecast_(forecast_options(options, hooks.from != nullptr)) {}

double RunProgress::elapsed() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }

double RunProgress::common_elapsed() const { return work_.broadcast(elapsed()); }

void RunProgress::begin_answer() { forecast_.begin_answer(worked()); }

void RunProgress::end_answer(double error, double safe_error, double cost, std::uint64_t rays) {
  error_ = error;
  forecast_.end_answer(worked(), safe_error, cost, static_cast<double>(rays));
}

void RunProgress::begin_round(const RoundPlan& plan) {
  forecast_.begin_round(worked(), {plan.more_cost, plan.more_rays, plan.squared_error});
}

Next RunProgress::report(std::uint64_t rays, const Solution* light) {
  const auto seconds = worked();
  const auto left = forecast_.left(seconds, static_cast<double>(rays));
  const auto done = forecast_.done(seconds, static_cast<double>(rays));
  if (left >= 0.0 && seconds > 0.0) beyond_ = std::max(0.0, left * done / seconds - (1.0 - done));
  const Progress progress{"light", done, rays, error_, beyond_};
  const auto begin = elapsed();
  if (light != nullptr && on_light_) on_light_(*light, progress);
  const auto next = context_.report(progress);
  monitor_seconds_ += elapsed() - begin;
  if (!work_.is_shared()) return next;
  is_stop_asked_ |= next == Next::stop;
  return Next::go_on;
}

bool RunProgress::is_stopped(Next next) const {
  return work_.broadcast(next == Next::stop || is_stop_asked_);
}

}  // namespace luxel
