// SPDX-License-Identifier: Apache-2.0
#include "luxel/session/lamp_by_power.h"

#include "luxel/scene/band_colours.h"

namespace luxel {

LampByPower::LampByPower(const PatchSet& patches) {
  const auto colours = patches.colours();
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const auto& material = patches.material_of(p);
    if (!material.is_lamp()) continue;
    patch_.push_back(p);
    by_power_.add(static_cast<double>(patches.area[p]) * colours.lumens(material.emittance));
  }
}

}  // namespace luxel
