// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/patch/open_polygons.h"
#include "luxel/patch/patch_set.h"
#include "luxel/trace/tracer.h"

namespace luxel {

struct PortalOptions {
  // With more polygons there are no portals: where thousands of rooms have a window each, most shadow rays
  // would go to windows of other rooms.
  std::size_t max_polygons = 1024;
  double min_fraction = 0.1;  // of the lines through a polygon, that bring the sky's light to a surface
  // Maximum chance that a cosine ray from lit surfaces finds the sky; above it cosine rays suffice.
  double max_open = 0.25;
  double same_lines = 0.75;  // share of its lines that cross better ones, from which on it adds nothing
};

// Selects the polygons worth aiming at: through them the sky lights surfaces that see
// little of it, and no better polygon does so. Each is tested with 64 lines. The result
// depends only on the arguments, not on the number of threads. Cost: at most 0.3 ms per
// polygon.
std::vector<Portal> choose_portals(const PatchSet& patches, const Tracer& tracer,
                                   std::span<const OpenPolygon> polygons, const PortalOptions& options,
                                   const Context& context);

// Finds the portals of a scene and writes them into the patches made of it; none without a sky.
void set_portals(const Scene& scene, const Tracer& tracer, PatchSet& patches, const Context& context);
// Does the same with a tracer of its own.
void set_portals(const Scene& scene, PatchSet& patches, const Context& context);

}  // namespace luxel
