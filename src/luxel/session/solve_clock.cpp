// SPDX-License-Identifier: Apache-2.0
#include "luxel/session/solve_clock.h"

#include <algorithm>

#include "luxel/core/time_left.h"

namespace luxel {
namespace {

constexpr double window = 2.0;  // s, interval over which rays per second are averaged

}  // namespace

void SolveClock::pause() {
  if (!paused_since_) paused_since_ = Clock::now();
}

void SolveClock::resume() {
  if (paused_since_) begin_ += Clock::now() - *paused_since_;
  paused_since_.reset();
}

double SolveClock::seconds() const {
  return std::chrono::duration<double>((paused_since_ ? *paused_since_ : Clock::now()) - begin_).count();
}

void SolveClock::begin_solve() {
  resume();
  solve_begin_ = seconds();
}

void SolveClock::note(const Progress& progress, bool has_light, SessionStatus& status) {
  const auto now = seconds();
  status.stage = progress.stage;
  status.done = progress.done;
  status.seconds = now;
  status.rays = std::max(status.rays, progress.rays);
  marks_.push_back({now, status.rays});
  while (marks_.size() > 2 && now - marks_.front().seconds > window) marks_.pop_front();
  const auto span = now - marks_.front().seconds;
  if (span > 0.0) status.rays_per_second = static_cast<double>(status.rays - marks_.front().rays) / span;
  status.seconds_left = time_left(progress, solve_seconds());
  if (has_light && progress.error > 0.0) {
    status.error = progress.error;
    status.history.push_back({now, status.rays, progress.error});
  }
}

}  // namespace luxel
