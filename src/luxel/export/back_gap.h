// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "luxel/core/vector.h"
#include "luxel/export/target_application.h"
#include "luxel/patch/patch_set.h"

namespace luxel {

// Returns the distance, m, of a sheet's back from its front in a file for this program. 0 where the program
// shows a triangle from its front alone. Else both triangles are visible from either side, and a ray that
// meets two in one plane shows either: 5e-5 of the scene's diagonal, which is more than the positions of a
// quantised mesh are rounded by.
float back_gap(const PatchSet& patches, TargetApplication program);

// Moves each vertex by this distance along the normal of its triangles, their mean by area.
void move_outwards(std::span<Vec3> positions, std::span<const std::array<std::uint32_t, 3>> triangles,
                   float distance);

}  // namespace luxel
