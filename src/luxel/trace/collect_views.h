// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "luxel/patch/patch_set.h"
#include "luxel/trace/look_around.h"
#include "luxel/trace/views.h"

namespace luxel {

// Looks as views, with the sides they see listed once. weight: [look], scaled so that they add up to 1.
// cameras: number of looks, the last, which are those of cameras. Looks that see no side in the focus are
// left out.
Views collect_views(const PatchSet& patches, std::span<const Panorama> looks, std::span<const float> weight,
                    std::size_t cameras);

}  // namespace luxel
