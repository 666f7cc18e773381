// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "luxel/core/discrete_distribution.h"
#include "luxel/patch/patch_set.h"

namespace luxel {

// Patches that emit, chosen by power (in lumens).
class LampByPower {
 public:
  explicit LampByPower(const PatchSet& patches);
  bool empty() const { return patch_.empty(); }
  // u in [0, 1): a patch.
  std::size_t at(double u) const { return patch_[by_power_.choose(u)]; }

 private:
  std::vector<std::size_t> patch_;
  DiscreteDistribution by_power_;
};

}  // namespace luxel
