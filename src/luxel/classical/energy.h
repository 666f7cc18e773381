// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "luxel/classical/solve_report.h"

namespace luxel {

// Energy balance of a solution, and the power lost at the backs of each material.
struct EnergyAccount {
  EnergyBalance balance;
  std::vector<double> back_loss;  // [material], W summed over bands

  // Accounts for the emitted power only.
  EnergyAccount(const std::vector<double>& emitted, std::size_t materials) : back_loss(materials, 0.0) {
    const std::vector<double> zeros(emitted.size(), 0.0);
    balance = {emitted, zeros, zeros, zeros, zeros, zeros, zeros};
  }
};

}  // namespace luxel
