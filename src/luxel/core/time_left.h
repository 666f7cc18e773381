// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <chrono>
#include <optional>

#include "luxel/core/progress.h"

namespace luxel {

// Returns the seconds until the end of a run whose present stage has lasted `seconds`, with what later stages
// take. Nothing while that is not known, and below 1 %: no estimate exists yet, or it is too coarse.
inline std::optional<double> time_left(const Progress& progress, double seconds) {
  constexpr double min_done = 0.01;
  const auto done = std::min(progress.done, 1.0);
  if (!(done >= min_done) || progress.later < 0.0) return std::nullopt;
  return seconds * (1.0 - done + progress.later) / done;
}

// The time left of a run from stage to stage: until a stage has an estimate, that of the stage before counts
// down.
class TimeLeft {
 public:
  using Clock = std::chrono::steady_clock;

  // seconds: since the stage began.
  std::optional<double> note(const Progress& progress, double seconds, Clock::time_point now) {
    if (const auto left = time_left(progress, seconds)) {
      if (progress.later > 0.0)
        end_ = now + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(*left));
      return left;
    }
    if (!end_ || *end_ <= now) return std::nullopt;
    return std::chrono::duration<double>(*end_ - now).count();
  }

 private:
  std::optional<Clock::time_point> end_;  // of the run, as a stage with others after it expected it last
};

}  // namespace luxel
