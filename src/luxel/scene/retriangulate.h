// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "luxel/scene/scene.h"

namespace luxel {

struct Retriangulated {
  std::size_t surfaces = 0;
  std::size_t before = 0, after = 0;  // triangles of these surfaces
};

// Triangles go on in a neighbour with the same two vertices, as triangles of one primitive of a glTF file do;
// or with vertices in the same places.
enum class JoinedAt { vertices, places };

// Triangulates flat surfaces whose triangles are needles, as walls with arches that a program cut out of
// them: constrained Delaunay, with points added on long edges (flat_mesh.h). Light over such needles, and
// lines of shadows across them, would be combs. A surface is what triangles of one material and one object
// cover in one plane, joined at whole edges with the same colours and places on pictures. Triangles
// elsewhere, and narrow rectangles, stay as they are; points that are added on the border of a surface lie on
// the edges of its neighbours, which are not cut.
//
// Triangles of such a surface stand at the place of its first one, and have that one's line;
// Scene::retriangulated records them. Cost: a scan of the triangles; where there are needles, about 1.3 s per
// million triangles on the calling thread.
Retriangulated retriangulate_needles(Scene& scene, JoinedAt joined = JoinedAt::places);

}  // namespace luxel
