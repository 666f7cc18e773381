// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/export/simplify_mesh.h"

namespace luxel {

// Cuts patches at vertices that lie within their edges without being their corners, so that rasterised meshes
// have no cracks there: background or what lies behind shows through T-junctions where the two sides round
// differently. The new corner has the light that runs along the edge. Patches that no vertex lies on stay as
// they are, and all stay in the order of their triangles. Vertices count as on an edge as
// find_all_hanging_vertices() has it. Cost: that of it.
void close_t_junctions(SimplifiedMesh& mesh);

}  // namespace luxel
