// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "luxel/patch/patch_set.h"
#include "luxel/scene/band_colours.h"
#include "luxel/trace/panes.h"

namespace luxel {

// Effect of panes of glass on the colours behind them, in pictures. Exact in plain colour; with wavebands,
// the colour of white light behind them is used. Immutable; safe for any number of threads.
class PaneColours {
 public:
  PaneColours(const PatchSet& patches, const BandColours& colours);

  // Linear RGB, a factor of radiance; 1 where the ray crosses no pane before distance (m).
  Vec3d along(const Ray& ray, float distance) const;

 private:
  Panes panes_;
  std::vector<Vec3d> of_band_;  // [band]: linear RGB, their sum is 1 in each channel
};

}  // namespace luxel
