// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <optional>

#include "luxel/core/progress.h"
#include "luxel/session/session_snapshot.h"

namespace luxel {

// The clock of a solve, which stands while the solve is paused, and the rate at which rays are traced.
class SolveClock {
 public:
  SolveClock() : begin_(Clock::now()) {}

  void pause();
  void resume();
  double seconds() const;  // since the beginning, pauses apart
  // A solve begins, whose progress counts from now: the first one, or one that continues from its samples.
  void begin_solve();
  double solve_seconds() const { return seconds() - solve_begin_; }

  // Writes where the solve is into the status.
  void note(const Progress& progress, bool has_light, SessionStatus& status);

 private:
  using Clock = std::chrono::steady_clock;
  struct Mark {
    double seconds;
    std::uint64_t rays;
  };

  Clock::time_point begin_;
  std::optional<Clock::time_point> paused_since_;
  double solve_begin_ = 0.0;  // as seconds()
  std::deque<Mark> marks_;    // of the last seconds
};

}  // namespace luxel
