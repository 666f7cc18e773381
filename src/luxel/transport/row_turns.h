// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>

#include "luxel/parallel/workers.h"
#include "luxel/report/progress.h"

namespace luxel {

// Calls body(begin, end) for [0, count) cut at multiples of grain, in turns between which the monitor hears
// how far the stage "factors" has come. False where it said stop; then some were not done.
template <typename Body>
bool for_chunks_in_turns(std::size_t count, std::size_t grain, const Workers& workers, const Monitor& monitor,
                         Body body) {
  constexpr std::size_t chunks_a_thread = 8;
  const auto turn = grain * chunks_a_thread * static_cast<std::size_t>(workers.threads());
  for (std::size_t from = 0; from < count; from += turn) {
    const auto to = std::min(count, from + turn);
    workers.for_chunks(to - from, grain,
                       [&](std::size_t begin, std::size_t end, int) { body(from + begin, from + end); });
    const auto share = static_cast<double>(to) / static_cast<double>(count);
    if (tell(monitor, {"factors", share}) == Next::stop) return false;
  }
  return true;
}

}  // namespace luxel
