// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/core/progress.h"
#include "luxel/render/lightmap.h"

namespace luxel {

// Gives empty texels around charts the mean of those beside them that hold light (of eight), ring after ring,
// so that smaller copies of a page (mip levels) and wider filters read no darkness there. The standard error
// goes with the light. rings: how far out, texels. False where the monitor says stop: some margins then are
// not filled.
bool dilate(Lightmap& lightmap, int rings, const Monitor& monitor = {});

}  // namespace luxel
