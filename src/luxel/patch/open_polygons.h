// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "luxel/patch/flat_polygon.h"
#include "luxel/scene/scene.h"

namespace luxel {

// A flat convex polygon without a surface through which light may enter a room: counter-clockwise seen from
// where its normal points.
using OpenPolygon = std::vector<Vec3>;

// Finds possible windows and doors from the triangles alone: panes of glass (surfaces that let light pass);
// holes in walls, even where the wall is a soup of triangles, or several boxes that leave a gap; and missing
// walls, that is flat loops of open edges. Many of them are no windows; rays find out later which ones light
// something. At most `max_count`, the largest first. The same on every host.
//
// Cost: about 0.5 s for a million triangles, and at most 0.1 s for the holes.
std::vector<OpenPolygon> find_open_polygons(const Scene& scene, std::size_t max_count = 8192);

// The parts of find_open_polygons(), for tests. extent: diagonal of the scene, m.
std::vector<OpenPolygon> find_panes(std::span<const Triangle3> glass, double extent);
std::vector<OpenPolygon> find_wall_holes(std::span<const Triangle3> triangles, double extent);
std::vector<OpenPolygon> find_missing_walls(const Scene& scene);

}  // namespace luxel
