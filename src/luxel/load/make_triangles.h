// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "luxel/load/obj_mesh.h"
#include "luxel/report/progress.h"
#include "luxel/scene/scene.h"

namespace luxel {

// Fills the scene's triangle arrays from the mesh's polygons, each triangle wound so that its front is where
// the vertex normals point, if all its corners have one. Returns the triangles that were turned round for
// that; nothing where the monitor says stop. The scene's positions must be in place.
std::optional<Tally> make_triangles(const ObjMesh& mesh, Scene& scene, const Monitor& monitor);

}  // namespace luxel
