// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "luxel/core/context.h"
#include "luxel/import/polygon_mesh.h"
#include "luxel/scene/scene.h"

namespace luxel {

struct TriangleTallies {
  Tally turned;      // triangles that were turned round
  Tally without_uv;  // faces that lack texture coordinates, of materials that have a picture
};

// Fills the scene's triangle arrays from the mesh's polygons, each triangle wound so that its front is where
// the vertex normals point, if all its corners have one; its set of texture coordinates, where materials have
// pictures; and its colours, where the mesh has some. Faces without texture coordinates get a copy of their
// material without its pictures, which is added to the scene's. Fills nothing where the monitor stops the
// work. The scene's positions and materials must be in place.
std::optional<TriangleTallies> make_triangles(const PolygonMesh& mesh, Scene& scene, const Context& context);

}  // namespace luxel
