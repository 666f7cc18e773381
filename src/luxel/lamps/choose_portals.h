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
  // More are not worth it: where each room has a window and there are thousands, most shadow rays go to those
  // of other rooms. Then there are no portals.
  std::size_t max_polygons = 1024;
  double min_fraction = 0.1;  // of the lines through a polygon, that bring the sky's light to a surface
  // Chance that a cosine ray of what it lights finds the sky: where it is larger, cosine rays do well alone.
  double max_open = 0.25;
  double same_lines = 0.75;  // share of its lines that cross better ones, from which on it adds nothing
};

// Those of the polygons that are worth aiming at: through them the sky lights surfaces that see little of
// the sky, and no better one does it for them. Each is tried with 64 lines. The answer depends on the
// arguments alone, and not on the number of threads. Cost: at most 0.3 ms a
// polygon.
std::vector<Portal> choose_portals(const PatchSet& patches, const Tracer& tracer,
                                   std::span<const OpenPolygon> polygons, const PortalOptions& options,
                                   const Context& context);

// Finds the portals of a scene and writes them into the patches made of it; none without a sky.
void set_portals(const Scene& scene, const Tracer& tracer, PatchSet& patches, const Context& context);
// The same with a tracer of its own.
void set_portals(const Scene& scene, PatchSet& patches, const Context& context);

}  // namespace luxel
