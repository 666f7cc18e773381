// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/core/context.h"
#include "luxel/render/lightmap.h"

namespace luxel {

// Fills empty texels around charts with the mean of those beside them that hold light (of eight), ring after
// ring, so that mip levels and wider filters read no darkness there. The standard error goes with the light.
// rings: width of the margin, texels. Returns false where the monitor stops the work: some margins are then
// not filled.
bool dilate(Lightmap& lightmap, int rings, const Context& context = {});

}  // namespace luxel
