// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/export/simplify_mesh.h"

namespace luxel {

// Cuts patches at vertices that lie within their edges without being their corners, so that rasterised meshes
// have no cracks there: background or what lies behind shows through T-junctions where the two sides round
// differently. A new corner has the light interpolated along the edge. Patches without such vertices stay as
// they are, and all stay in the order of their triangles. Vertices on edges are those of
// find_all_hanging_vertices(), which also determines the cost.
void close_t_junctions(SimplifiedMesh& mesh);

}  // namespace luxel
