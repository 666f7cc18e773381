// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <optional>

#include "luxel/core/progress.h"
#include "luxel/session/live_state.h"

namespace luxel {

// How a solve gets on: its clock, which stands while it is held, and how fast rays are traced.
class Pace {
 public:
  Pace() : begin_(Clock::now()) {}

  void hold();
  void go_on();
  double seconds() const;  // since the beginning, but for what it was held
  // A solve begins, whose progress counts from now: the first one, or one that goes on with its samples.
  void begin_solve();
  double solve_seconds() const { return seconds() - solve_begin_; }

  // Writes where the solve is into the status.
  void note(const Progress& progress, LiveStatus& status);

 private:
  using Clock = std::chrono::steady_clock;
  struct Mark {
    double seconds;
    std::uint64_t rays;
  };

  Clock::time_point begin_;
  std::optional<Clock::time_point> held_since_;
  double solve_begin_ = 0.0;  // as seconds()
  std::deque<Mark> marks_;    // of the last seconds
};

}  // namespace luxel
