// SPDX-License-Identifier: Apache-2.0
#include "luxel/patch/patch_set.h"

#include <algorithm>

namespace luxel {

bool BandMaterial::is_lamp() const {
  return std::any_of(emittance.begin(), emittance.end(), [](float e) { return e > 0.0f; });
}

}  // namespace luxel
