// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "luxel/core/time_left.h"
#include "luxel/solve/run_progress.h"

namespace luxel {
namespace {

// Seconds when the samples of a round were taken, its answer was there and the next was planned; then what
// there was: rays, cost, error with its uncertainty, and the error that the plan expects of the next round.
struct Round {
  double sampled, answered, planned, rays, cost, error, expected;
};

struct Recorded {
  std::string name;
  double error;  // asked for
  std::vector<Round> rounds;
};

// Runs of the solver on two cores.
const std::vector<Recorded> recorded{
    {"modern hall",
     0.02,
     {{2.70, 4.99, 5.11, 9.097e6, 5.970e6, 0.0897, 0.0182},
      {10.20, 12.91, 13.02, 40.390e6, 29.848e6, 0.0206, 0.0076},
      {15.30, 18.03, 18.03, 58.861e6, 44.772e6, 0.0103, 0.0}}},
    {"kitchen",
     0.02,
     {{6.33, 13.03, 13.55, 19.327e6, 17.291e6, 0.3270, 0.0662},
      {30.89, 38.74, 39.13, 97.745e6, 86.457e6, 0.0803, 0.0165},
      {59.72, 69.88, 69.88, 246.730e6, 216.140e6, 0.0188, 0.0}}},
    {"reading room",
     0.02,
     {{4.50, 7.10, 7.33, 13.208e6, 9.481e6, 0.1853, 0.0377},
      {17.59, 20.61, 20.86, 60.422e6, 47.403e6, 0.0601, 0.0184},
      {35.86, 40.63, 41.20, 138.939e6, 118.510e6, 0.0262, 0.0143},
      {59.63, 66.13, 66.13, 227.901e6, 197.230e6, 0.0152, 0.0}}},
};

struct Judged {
  double worst_ratio = 1.0;  // of the time left to the true one, or inverse, from a tenth of the way to 0.95
  double max_fall = 0.0;     // of the fraction done
  double last = 0.0;         // fraction done at the end
};

Judged judged(const Recorded& run) {
  TimeForecast forecast({.error = run.error, .aim = 0.8});
  const auto whole = run.rounds.back().answered;
  Judged result;
  const auto look = [&](double seconds, double rays) {
    const auto before = result.last;
    result.last = forecast.done(seconds, rays);
    result.max_fall = std::max(result.max_fall, before - result.last);
    const auto left = time_left({.stage = "light", .done = result.last}, seconds);
    if (!left || seconds < 0.1 * whole || seconds > 0.95 * whole) return;
    const auto ratio = *left / (whole - seconds);
    result.worst_ratio = std::max({result.worst_ratio, ratio, 1.0 / ratio});
  };
  Round before{};
  for (const auto& round : run.rounds) {
    for (const auto part : {0.1, 0.3, 0.5, 0.7, 0.9})
      look(std::lerp(before.planned, round.sampled, part), std::lerp(before.rays, round.rays, part));
    forecast.begin_answer(round.sampled);
    for (const auto part : {0.1, 0.3, 0.5, 0.7, 0.9})
      look(std::lerp(round.sampled, round.answered, part), round.rays);
    forecast.end_answer(round.answered, round.error, round.cost, round.rays);
    look(round.answered, round.rays);
    const auto* next = &round + 1;
    if (&round != &run.rounds.back())
      forecast.begin_round(
          round.planned, {next->cost - round.cost, next->rays - round.rays, round.expected * round.expected});
    before = round;
  }
  return result;
}

TEST(TimeForecast, is_within_a_factor_of_1_8_in_recorded_runs_and_never_runs_backwards) {
  for (const auto& run : recorded) {
    const auto result = judged(run);
    EXPECT_LT(result.worst_ratio, 1.8) << run.name;
    EXPECT_EQ(result.max_fall, 0.0) << run.name;
    EXPECT_EQ(result.last, 1.0) << run.name;
  }
}

// Rounds that double a cost of 1, with 1 s of samples per cost and 2 s for an answer.
class MadeUp {
 public:
  explicit MadeUp(const TimeForecastOptions& options) : forecast_(options) {}

  void answer(double error) {
    forecast_.begin_answer(seconds_);
    forecast_.end_answer(seconds_ += 2.0, error, cost_, cost_);
  }
  void sample() {
    forecast_.begin_round(seconds_, {cost_, cost_, 0.0});
    seconds_ += cost_;
    cost_ *= 2.0;
  }
  double left() const { return forecast_.left(seconds_, cost_); }
  double seconds() const { return seconds_; }
  TimeForecast& forecast() { return forecast_; }

 private:
  TimeForecast forecast_;
  double seconds_ = 1.0;
  double cost_ = 1.0;
};

TEST(TimeForecast, makes_none_before_the_first_answer_nor_after_one_that_is_far_off) {
  MadeUp run({.error = 0.02});
  EXPECT_LT(run.left(), 0.0);
  EXPECT_EQ(run.forecast().done(1.0, 1.0), 0.0);
  run.answer(0.5);
  run.sample();
  EXPECT_LT(run.left(), 0.0);
  run.answer(0.1);
  run.sample();
  EXPECT_GT(run.left(), 0.0);
}

TEST(TimeForecast, of_an_error_that_is_reached_leaves_nothing) {
  MadeUp run({.error = 0.02});
  run.answer(0.02);
  EXPECT_EQ(run.left(), 0.0);
  EXPECT_EQ(run.forecast().done(run.seconds(), 1.0), 1.0);
}

TEST(TimeForecast, grows_as_the_error_asked_for_falls) {
  double before = 0.0;
  for (const auto error : {0.05, 0.02, 0.01, 0.005}) {
    MadeUp run({.error = error});
    for (const auto reached : {0.3, 0.2, 0.14}) {
      run.answer(reached);
      run.sample();
    }
    EXPECT_GT(run.left(), 1.5 * before) << error;
    before = run.left();
  }
}

// Each round doubles the samples: 3 more fit under 64 rays after 8, and no other does.
TEST(TimeForecast, ends_where_rays_end_the_run) {
  MadeUp run({.rays = 64.0, .max_growth = 1.0});
  for (int i = 0; i < 3; ++i) {
    run.answer(0.1);
    run.sample();
  }
  // 2 s for the answer now, then 8, 16 and 32 s of samples with an answer each, give or take.
  EXPECT_GT(run.left(), 30.0);
  EXPECT_LT(run.left(), 75.0);
}

TEST(TimeForecast, ends_before_the_time_that_ends_the_run) {
  MadeUp run({.seconds = 40.0, .max_growth = 1.0});
  for (int i = 0; i < 3; ++i) {
    run.answer(0.1);
    run.sample();
  }
  EXPECT_GT(run.left(), 2.0);
  EXPECT_LT(run.seconds() + run.left(), 44.0);
}

// The iteration takes 1 s in the first two answers and 5 s in the third, what follows 1 s in all.
TEST(TimeForecast, of_an_answer_counts_what_follows_the_iteration_as_in_the_last_one) {
  TimeForecast forecast({.error = 0.02});
  double seconds = 1.0;
  for (int i = 0; i < 3; ++i) {
    const auto cost = std::pow(2.0, i);
    forecast.begin_answer(seconds);
    forecast.end_iteration(seconds += i < 2 ? 1.0 : 5.0);
    if (i == 2) break;
    forecast.end_answer(seconds += 1.0, 0.05 / cost, cost, cost);
    forecast.begin_round(seconds, {cost, cost, 1e-6});
    seconds += cost;
  }
  EXPECT_DOUBLE_EQ(forecast.left(seconds, 4.0), 1.0);
  EXPECT_DOUBLE_EQ(forecast.left(seconds + 0.5, 4.0), 0.5);
}

TEST(TimeForecast, stands_while_it_grows) {
  MadeUp run({.error = 0.02});
  run.answer(0.1);
  run.sample();
  run.answer(0.03);
  run.sample();
  const auto done = run.forecast().done(run.seconds(), 4.0);
  run.answer(0.1);  // it was chance
  run.sample();
  EXPECT_EQ(run.forecast().done(run.seconds(), 8.0), done);
}

TEST(TimeForecast, of_a_resumed_run_is_made_at_once) {
  MadeUp run({.error = 0.01, .is_resumed = true});
  run.answer(0.5);
  run.sample();
  EXPECT_GT(run.left(), 0.0);
}

TEST(TimeLeft, is_the_rest_of_a_whole_of_which_a_part_has_passed) {
  EXPECT_EQ(time_left({.stage = "light", .done = 0.25}, 10.0), 30.0);
  EXPECT_EQ(time_left({.stage = "light", .done = 1.0}, 10.0), 0.0);
  EXPECT_FALSE(time_left({.stage = "light", .done = 0.0}, 10.0));
  EXPECT_FALSE(time_left({.stage = "light", .done = 0.005}, 10.0));
  // A stage of 40 s, of which 10 have passed, and 60 s of later stages.
  EXPECT_EQ(time_left({.stage = "light", .done = 0.25, .later = 1.5}, 10.0), 90.0);
  EXPECT_EQ(time_left({.stage = "light", .done = 1.0, .later = 1.5}, 10.0), 15.0);
  EXPECT_FALSE(time_left({.stage = "light", .done = 0.5, .later = -1.0}, 10.0));
}

TEST(TimeLeft, counts_down_until_the_next_stage_has_an_estimate_of_its_own) {
  using namespace std::chrono_literals;
  TimeLeft left;
  const TimeLeft::Clock::time_point begin{};
  EXPECT_FALSE(left.note({.stage = "refine", .done = 0.5, .later = -1.0}, 10.0, begin));
  EXPECT_EQ(left.note({.stage = "refine", .done = 0.5, .later = 1.0}, 10.0, begin), 30.0);
  EXPECT_EQ(left.note({.stage = "light"}, 0.0, begin + 10s), 20.0);
  EXPECT_EQ(left.note({.stage = "light"}, 4.0, begin + 14s), 16.0);
  EXPECT_EQ(left.note({.stage = "light", .done = 0.5}, 8.0, begin + 18s), 8.0);
  EXPECT_FALSE(left.note({.stage = "light"}, 30.0, begin + 40s)) << "it lasted longer than expected";
}

}  // namespace
}  // namespace luxel
