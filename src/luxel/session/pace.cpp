// SPDX-License-Identifier: Apache-2.0
#include "luxel/session/pace.h"

#include <algorithm>

#include "luxel/core/time_left.h"

namespace luxel {
namespace {

constexpr double window = 2.0;  // s, over which rays per second are counted

}  // namespace

void Pace::hold() {
  if (!held_since_) held_since_ = Clock::now();
}

void Pace::go_on() {
  if (held_since_) begin_ += Clock::now() - *held_since_;
  held_since_.reset();
}

double Pace::seconds() const {
  return std::chrono::duration<double>((held_since_ ? *held_since_ : Clock::now()) - begin_).count();
}

void Pace::begin_solve() {
  go_on();
  solve_begin_ = seconds();
}

void Pace::note(const Progress& progress, LiveStatus& status) {
  const auto now = seconds();
  status.stage = progress.stage;
  status.done = progress.done;
  status.seconds = now;
  status.rays = std::max(status.rays, progress.rays);
  marks_.push_back({now, status.rays});
  while (marks_.size() > 2 && now - marks_.front().seconds > window) marks_.pop_front();
  const auto span = now - marks_.front().seconds;
  if (span > 0.0) status.rays_per_second = static_cast<double>(status.rays - marks_.front().rays) / span;
  status.seconds_left = time_left(progress.done, solve_seconds());
  if (progress.light != nullptr && progress.error > 0.0) {
    status.error = progress.error;
    status.history.push_back({now, status.rays, progress.error});
  }
}

}  // namespace luxel
