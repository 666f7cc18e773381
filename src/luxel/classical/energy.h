// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace luxel {

// Where the power of lamps and sky went. Arrays are [band], W. emitted + from_sky = absorbed + escaped +
// lost_at_backs + unshot, to rounding; shooting under lamps and sky: to a ray, which of them it belongs to.
struct EnergyBalance {
  std::vector<double> emitted;  // by lamps
  // What the sky sends onto sides that take part: all fronts, and backs of two-sided materials. What it sends
  // past the scene, or straight to a back that absorbs all, is nobody's business and counted nowhere.
  std::vector<double> from_sky;
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
    balance = {emitted, none, none, none, none, none};
  }
};

}  // namespace luxel
