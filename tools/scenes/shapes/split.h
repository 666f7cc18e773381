// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenes/shapes/mesh.h"

namespace luxel::scenes {

// Every edge cut in `pieces` equal ones and every triangle in pieces², all of one shape: the same surface,
// finer. Triangles that share an edge (the same two points) share its new points too, so what is closed stays
// closed. With 1 the mesh as it is.
Mesh split(const Mesh& mesh, int pieces);

}  // namespace luxel::scenes
