// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
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

// Runs of the solver; processor time over 2, so that what else the machine did is not in it.
const std::vector<Recorded> recorded{
    {"modern hall",
     0.02,
     {{2.27, 4.94, 4.99, 4.385e6, 2.788e6, 0.1315, 0.0315},
      {5.65, 8.04, 8.10, 6.094e6, 4.201e6, 0.0670, 0.0215},
      {9.04, 11.70, 11.80, 9.191e6, 6.541e6, 0.0463, 0.0301},
      {12.95, 15.82, 16.00, 13.322e6, 10.022e6, 0.0337, 0.0237},
      {17.42, 20.25, 20.41, 19.161e6, 15.069e6, 0.0290, 0.0219},
      {22.60, 26.22, 26.48, 28.826e6, 23.025e6, 0.0236, 0.0181},
      {29.78, 34.03, 34.03, 42.765e6, 34.540e6, 0.0191, 0.0}}},
    {"kitchen",
     0.02,
     {{5.84, 13.05, 13.23, 10.492e6, 7.634e6, 0.3763, 0.0920},
      {15.72, 23.16, 23.37, 14.487e6, 11.467e6, 0.1154, 0.0447},
      {26.02, 33.27, 33.53, 21.166e6, 17.592e6, 0.0724, 0.0394},
      {38.55, 45.24, 45.57, 38.066e6, 33.086e6, 0.0446, 0.0298},
      {53.76, 62.15, 62.62, 64.859e6, 57.778e6, 0.0320, 0.0227},
      {75.75, 85.05, 86.11, 107.966e6, 97.938e6, 0.0222, 0.0173},
      {101.83, 113.05, 113.05, 160.704e6, 146.907e6, 0.0171, 0.0}}},
    {"reading room",
     0.04,
     {{3.02, 5.47, 5.55, 5.556e6, 3.801e6, 0.2132, 0.0444},
      {6.69, 8.91, 9.01, 7.802e6, 5.701e6, 0.1093, 0.0335},
      {10.45, 12.56, 12.67, 11.202e6, 8.552e6, 0.0906, 0.0395},
      {16.14, 18.70, 18.89, 21.860e6, 17.944e6, 0.0672, 0.0380},
      {26.65, 30.47, 30.90, 47.088e6, 40.977e6, 0.0462, 0.0360},
      {37.73, 42.34, 42.34, 69.524e6, 61.474e6, 0.0376, 0.0}}},
};

struct Judged {
  double worst_ratio = 1.0;  // of the time left to the true one, either way, from a tenth of the way to 0.95
  double max_fall = 0.0;     // of the fraction done
  double last = 0.0;         // fraction done at the end
};

Judged judged(const Recorded& run) {
  TimeForecast forecast({.error = run.error, .aim = 0.9});
  const auto whole = run.rounds.back().answered;
  Judged result;
  const auto look = [&](double seconds, double rays) {
    const auto before = result.last;
    result.last = forecast.done(seconds, rays);
    result.max_fall = std::max(result.max_fall, before - result.last);
    const auto left = time_left(result.last, seconds);
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

TEST(TimeForecast, stands_while_it_grows) {
  MadeUp run({.error = 0.02});
  run.answer(0.1);
  run.sample();
  run.answer(0.03);
  run.sample();
  const auto done = run.forecast().done(run.seconds(), 4.0);
  run.answer(0.1);  // it was luck
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
  EXPECT_EQ(time_left(0.25, 10.0), 30.0);
  EXPECT_EQ(time_left(1.0, 10.0), 0.0);
  EXPECT_FALSE(time_left(0.0, 10.0));
  EXPECT_FALSE(time_left(0.005, 10.0));
}

}  // namespace
}  // namespace luxel
