// SPDX-License-Identifier: Apache-2.0
#include "luxel/session/lamp_by_power.h"

#include <algorithm>

namespace luxel {

LampByPower::LampByPower(const PatchSet& patches) {
  double power = 0.0;
  const auto colours = patches.colours();
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const auto& material = patches.material_of(p);
    if (!material.is_lamp()) continue;
    power += static_cast<double>(patches.area[p]) * colours.lumens(material.emittance);
    patch_.push_back(p);
    up_to_.push_back(power);
  }
}

std::size_t LampByPower::at(double u) const {
  const auto found = std::upper_bound(up_to_.begin(), up_to_.end() - 1, u * up_to_.back());
  return patch_[static_cast<std::size_t>(found - up_to_.begin())];
}

}  // namespace luxel
