// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "luxel/surface/light_sheets.h"
#include "luxel/surface/smooth_sheet.h"

namespace luxel {

// Bounds single replicates that lie far above those of the sides around and above the other replicates of
// their own side: a ray of great weight that one small side caught, which smoothing would leave as a speck,
// because the half of the replicates that chooses does not contain it. The excess of such a value is given to
// the sides around it, in the same replicate, so that means over the surface and their spread stay as they
// are; all bands by one factor, so that hues stay.
//
// A value is bounded by m + 4 (q - m), m the median and q the ninth decile of the replicates of all sides
// that light reaches within about two median patches; where its side's own median is above that, by four
// times that. Where fewer than 8 such sides are near, those of the finest scale decide at which 8 are.
// Nothing is bounded where q is not above m: too few rays to judge by.
//
// grids: the windows of all scales, the finest first. values: see SheetLight. Cost: about 0.3 us per receiver
// of 8 replicates.
void spread_outliers(const LightSheet& sheet, std::span<const WindowGrid> grids, WindowColumns columns,
                     std::vector<float>& values, const LoopRunner& run);

}  // namespace luxel
