// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "luxel/patch/patch_set.h"
#include "luxel/patch/side.h"
#include "luxel/solution/solution.h"

namespace luxel {

// The irradiance of patch sides by their number: 2 * patch is a patch's front, 2 * patch + 1 its back.
class SideLight {
 public:
  // Keeps references.
  SideLight(const PatchSet& patches, const Solution& solution) : patches_(patches), solution_(solution) {}

  std::size_t bands() const { return solution_.bands.size(); }
  // [band], W/m².
  const float* at(SideId side) const {
    const auto& irradiance = solution_.irradiance.of(side);
    return irradiance.data() + side.patch() * bands();
  }
  // Returns the weight of a side's value, m². It is 0 for the back of a one-sided material, which has no
  // light because none is computed there.
  double weight(SideId side) const {
    return !side.is_back() || patches_.material_of(side.patch()).two_sided
               ? static_cast<double>(patches_.area[side.patch()])
               : 0.0;
  }

 private:
  const PatchSet& patches_;
  const Solution& solution_;
};

}  // namespace luxel
