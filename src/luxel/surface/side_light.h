// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "luxel/patch/patch_set.h"
#include "luxel/solution/solution.h"

namespace luxel {

// The irradiance of patch sides by their number: 2 * patch is a patch's front, 2 * patch + 1 its back.
class SideLight {
 public:
  // Keeps references.
  SideLight(const PatchSet& patches, const Solution& solution) : patches_(patches), solution_(solution) {}

  std::size_t bands() const { return solution_.bands.size(); }
  // [band], W/m².
  const float* at(std::size_t side) const {
    const auto& irradiance = side % 2 == 0 ? solution_.irradiance_front : solution_.irradiance_back;
    return irradiance.data() + side / 2 * bands();
  }
  // What a side's value weighs, m². The back of a one-sided material holds no light because nothing was ever
  // asked there: it has no say.
  double weight(std::size_t side) const {
    return side % 2 == 0 || patches_.material_of(side / 2).two_sided
               ? static_cast<double>(patches_.area[side / 2])
               : 0.0;
  }

 private:
  const PatchSet& patches_;
  const Solution& solution_;
};

}  // namespace luxel
