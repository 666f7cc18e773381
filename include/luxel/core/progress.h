// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string_view>

namespace luxel {

enum class Next { go_on, stop };

/// Progress of a long call.
struct Progress {
  std::string_view stage;  ///< "load", "patches", "hierarchy", "light", "picture", ...
  double done = 0.0;       ///< fraction of this stage, 0 to 1: of its time where it forecasts that
  std::uint64_t rays = 0;  ///< traced so far in this stage
  double error = 0.0;      ///< standard error so far, by the measure that ends the run; 0: not known yet
  /// Time beyond the fraction that is not done, over that of this whole stage: what later stages of the run
  /// are expected to take, or this one since its forecast was too short. Negative: not known yet.
  double later = 0.0;
};

/// Called from the calling thread, a few times per second while work goes on. Returning stop ends the call as
/// soon as possible (well under a second) with the result so far, which is valid. May be empty.
using Monitor = std::function<Next(const Progress&)>;

inline Next tell(const Monitor& monitor, const Progress& progress) {
  return monitor ? monitor(progress) : Next::go_on;
}

}  // namespace luxel
