// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/load/obj_mesh.h"
#include "luxel/scene/scene.h"

namespace luxel {

// How many times its own size (the longest side of its box) a scene may reach from the file's zero before its
// positions count from an origin of their own. Up to there floats tell places apart that are a millionth of
// the scene's size from each other.
inline constexpr double far_in_sizes = 8.0;

// Fills positions and origin of the scene: coordinates times scale, in floats. Where the box of all that
// faces use reaches farther than far_in_sizes, they are taken in doubles from its middle, rounded along each
// axis to a multiple of the power of two that is next above its longest side.
void place_positions(const ObjMesh& mesh, double scale, Scene& scene);

}  // namespace luxel
