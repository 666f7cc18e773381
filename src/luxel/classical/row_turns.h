// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>

#include "luxel/core/context.h"
#include "luxel/core/progress.h"

namespace luxel {

// The number of items between two polls of the monitor: as many as take about a fifth of a second. Results do
// not depend on it.
class TurnLength {
 public:
  explicit TurnLength(std::size_t first) : min_(first), length_(first) {}

  std::size_t length() const { return length_; }
  void begin() { begin_ = Clock::now(); }
  void end() {
    const auto seconds = std::chrono::duration<double>(Clock::now() - begin_).count();
    if (seconds < 0.1) length_ *= 2;
    if (seconds > 0.3) length_ = std::max(min_, length_ / 2);
  }

 private:
  using Clock = std::chrono::steady_clock;
  std::size_t min_, length_;
  Clock::time_point begin_;
};

// Calls body(begin, end) for [0, count) cut at multiples of grain, in turns between which the monitor
// receives the progress of the stage "factors". Returns false where it stopped the work; some items were then
// not done.
template <typename Body>
bool for_chunks_in_turns(std::size_t count, std::size_t grain, const Context& context, Body body) {
  TurnLength turn(grain * static_cast<std::size_t>(context.threads()));
  for (std::size_t from = 0; from < count;) {
    const auto to = std::min(count, from + turn.length());
    turn.begin();
    context.for_chunks(to - from, grain,
                       [&](std::size_t begin, std::size_t end, int) { body(from + begin, from + end); });
    turn.end();
    from = to;
    const auto fraction = static_cast<double>(to) / static_cast<double>(count);
    if (context.report({"factors", fraction}) == Next::stop) return false;
  }
  return true;
}

}  // namespace luxel
