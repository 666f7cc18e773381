// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
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

// The balance of a solution, and which materials' backs took their part of it.
struct EnergyAccount {
  EnergyBalance balance;
  std::vector<double> back_loss;  // [material], W summed over bands

  // Nothing but the emitted power is accounted for yet.
  EnergyAccount(const std::vector<double>& emitted, std::size_t materials) : back_loss(materials, 0.0) {
    const std::vector<double> none(emitted.size(), 0.0);
    balance = {emitted, none, none, none, none};
  }
};

}  // namespace luxel
