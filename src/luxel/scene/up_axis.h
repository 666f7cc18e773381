// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/scene/scene.h"

namespace luxel {

// Estimates which way is up in a scene whose file does not define it: (0, 1, 0) or (0, 0, 1). Several signs
// vote:
// - names: surfaces called floor, ceiling, ground and the like are level;
// - level surfaces: treads, boards and table tops are many;
// - symmetry: the two horizontal axes resemble each other, the vertical one differs, so that a tall atrium
//   has as much wall along x as along its other horizontal axis;
// - turned things: a chair or column that stands turned about the vertical has faces that are upright but
//   along no horizontal axis;
// - lamps shine down from above.
// Where nothing decides it is y. Depends on the triangles' shapes, names and lamps, not on scale, origin,
// windings (but of lamps) or the order of triangles. Cost: one pass over the triangles.
Vec3 up_axis(const Scene& scene);

// Returns the up axis: `given`, where it is not 0; else that of the scene's file, else an estimate.
Vec3 up_of_scene(const Scene& scene, const Vec3& given = Vec3(0.0f));

}  // namespace luxel
