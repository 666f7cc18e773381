// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace luxel {

// Where the emitted power went. Arrays are [band], W. emitted = absorbed + escaped + lost_at_backs + unshot,
// to rounding.
struct EnergyBalance {
  std::vector<double> emitted;
  std::vector<double> absorbed;       // taken up by surfaces that received it
  std::vector<double> escaped;        // left the scene
  std::vector<double> lost_at_backs;  // met the back of a one-sided material
  std::vector<double> unshot;         // not yet propagated when the iteration ended
};

}  // namespace luxel
