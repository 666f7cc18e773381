// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/core/progress.h"
#include "luxel/core/work_partition.h"
#include "luxel/solve/ray_allocation.h"
#include "luxel/solve/sampled.h"

namespace luxel {

// Limits of a sampled solve, and the allowed growth of its rounds.
struct TimeForecastOptions {
  double error = 0.0;       // by the measure that ends the run; 0: it is not ended by the error
  double aim = 1.0;         // of the squared error, at which a round is planned
  double rays = 0.0;        // 0: no bound
  double ray_budget = 0.0;  // see SampledOptions; 0: no bound
  double seconds = 0.0;     // 0: no bound
  double min_growth = 0.5;  // minimum cost of a round over that of all before it
  double max_growth = 3.0;  // maximum of that ratio
  bool is_resumed = false;  // there were rounds before those that are reported
};

// The samples that a round adds to those before.
struct PlannedRound {
  double cost = 0.0;
  double rays = 0.0;
  double squared_error = 0.0;  // squared error after it, as the plan expects it; 0: unknown
};

// Estimates when a sampled solve ends, from its previous rounds. A round takes samples, then computes an
// answer with a stated error. The estimate repeats rounds until an end is reached: squared error ~ cost^-p;
// seconds of samples ~ cost; seconds of an answer = a + b cost. p, a and b come from the last rounds; p is
// shrunk towards a prior, because a furnished room's first rounds help much more than its later ones.
//
// Has no clock: all times are seconds since the solve began, as the caller measures them. Costs are in any
// unit.
class TimeForecast {
 public:
  explicit TimeForecast(const TimeForecastOptions& options) : options_(options) {}

  // Changes the error that ends the run.
  void aim_at(double error) { options_.error = error; }
  // The samples of a round are taken: its answer begins.
  void begin_answer(double seconds);
  // The iteration of the answer has ended. What follows, smoothing and the stated error, takes as long for
  // each answer, while the iteration grows with the samples.
  void end_iteration(double seconds);
  // Ends the answer. error: with its uncertainty; cost and rays: of all samples so far.
  void end_answer(double seconds, double error, double cost, double rays);
  // Begins the next round, with its planned cost, rays and squared error.
  void begin_round(double seconds, const PlannedRound& plan);

  // Returns the seconds from `seconds` to the end, when the run has traced `rays`; negative while there is no
  // estimate: the first answer is missing, or too far from the error target.
  double left(double seconds, double rays) const;
  // Fraction of the run's time that has passed. Never decreases: if the estimate grows, it is constant until
  // time has caught up. 0 while there is no estimate.
  double done(double seconds, double rays);

 private:
  struct Answer {
    double seconds = 0.0;  // it took
    double squared_error = 0.0;
    double cost = 0.0;
    double rays = 0.0;
  };
  struct Sampling {  // the samples of one round
    double seconds = 0.0;
    double cost = 1.0;
  };
  enum class Phase { first_samples, first_answer, planning, sampling, answering, smoothing };

  bool is_reached(double squared_error) const {
    return options_.error > 0.0 && squared_error <= options_.error * options_.error;
  }
  bool is_bound_broken(double seconds, const Answer& last, double more_cost) const;
  double learned_exponent() const;
  double planned_growth(double squared_error) const;
  double sampling_seconds(double more_cost) const;
  double answer_seconds(double cost) const;
  double rays_per_cost() const;
  double sampling_left(double seconds, double rays) const;
  Answer answer_after(const Answer& last, double more_cost, std::size_t answers) const;
  double weight_of_next(double squared_error) const;
  Answer planned_answer() const;
  double rounds_after(double seconds, Answer last, std::size_t answers) const;

  TimeForecastOptions options_;
  Phase phase_ = Phase::first_samples;
  double phase_begin_ = 0.0;     // seconds
  double answer_begin_ = 0.0;    // seconds
  double last_smoothing_ = 0.0;  // seconds, of the last answer after its iteration; 0: unknown
  std::vector<Answer> answers_;
  Sampling last_sampling_;
  PlannedRound plan_;  // the last one
  double done_ = 0.0;
};

// Progress of a sampled run: the caller's monitor, the run's clock, and its estimate of the remaining time,
// from which Progress::done is computed.
class RunProgress {
 public:
  // Keeps references to hooks and context.
  RunProgress(const SampledOptions& options, const SolveHooks& hooks, const Context& context);

  double elapsed() const;         // s since it was made
  double common_elapsed() const;  // that of the first process, for decisions

  // Call in this order in every round. error: stated; safe_error: with its uncertainty; cost: of all samples.
  void begin_answer();
  void end_iteration() { forecast_.end_iteration(worked()); }
  void aim_at(double error) { forecast_.aim_at(error); }  // where the error that ends the run changes
  void end_answer(double error, double safe_error, double cost, std::uint64_t rays);
  void begin_round(const RoundPlan& plan);

  // Reports the fraction of the run's time that has passed; with light, publishes that first.
  Next report(std::uint64_t rays, const Solution* light = nullptr);
  // Returns whether the monitor of the first process stops the run: the same in all processes, so that they
  // stop together. Called between answers.
  bool is_stopped(Next next) const;

 private:
  using Clock = std::chrono::steady_clock;

  double worked() const { return elapsed() - monitor_seconds_; }

  const LightSink& on_light_;
  const Context& context_;
  SharedWork work_;
  Clock::time_point begin_ = Clock::now();
  // Inside the monitor, where a program may hold the run: no time of the forecast.
  double monitor_seconds_ = 0.0;
  bool is_stop_asked_ = false;  // of several processes
  TimeForecast forecast_;
  double error_ = 0.0;
  double beyond_ = 0.0;  // Progress::later
};

}  // namespace luxel
