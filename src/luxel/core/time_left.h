// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

namespace luxel {

// Returns the seconds until the end of a stage whose fraction `done` took `seconds`. Nothing below 1 %: no
// estimate exists yet, or it is too coarse.
inline std::optional<double> time_left(double done, double seconds) {
  constexpr double min_done = 0.01;
  if (!(done >= min_done)) return std::nullopt;
  return done < 1.0 ? seconds * (1.0 - done) / done : 0.0;
}

}  // namespace luxel
