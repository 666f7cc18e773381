// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "luxel/patch/patch_set.h"
#include "luxel/scene/band_colours.h"

namespace luxel {

// Visible colour of the sky, W/(m² sr), linear RGB: for a sky in patches, a smooth field through their
// centres, since a picture of the patches would show their edges. Immutable; safe for any number of threads.
class SkyColours {
 public:
  SkyColours(const PatchSet& patches, const BandColours& colours);

  // Returns whether all directions above the horizon have one radiance.
  bool is_even_above() const { return radiance_.empty() || patches_.upper() == 1; }
  // Where is_even_above(): that radiance.
  Vec3d above() const { return radiance_.empty() ? Vec3d(0.0) : radiance_[patches_.is_one() ? 0 : 1]; }
  // direction: unit.
  Vec3d at(const Vec3d& direction) const;

 private:
  SkyPatches patches_;
  std::vector<Vec3d> radiance_;  // [sky patch]; empty: dark
};

}  // namespace luxel
