// SPDX-License-Identifier: Apache-2.0
#include "luxel/patch/patch_set.h"

#include <algorithm>

namespace luxel {

namespace {

bool any_above_zero(const std::vector<float>& bands) {
  return std::any_of(bands.begin(), bands.end(), [](float x) { return x > 0.0f; });
}

}  // namespace

bool BandMaterial::is_lamp() const { return any_above_zero(emittance); }

bool PatchSet::has_sky() const { return any_above_zero(sky); }

}  // namespace luxel
