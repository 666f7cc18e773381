// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/core/context.h"
#include "luxel/render/lightmap.h"
#include "luxel/surface/make_charts.h"

namespace luxel {

struct SeamOptions {
  double weight_of_light = 0.01;  // of what a texel holds, against agreement at one place of a seam; above 0
  int max_steps = 200;            // of conjugate gradients
};

// Makes both sides of a seam read the same light: where a smooth surface is parted between two charts, texels
// along the edge change as little as they can so that at every half texel along it the bilinear lookups in
// both charts agree; least squares, by conjugate gradients (Iwanicki, "Lighting Technology of The Last of
// Us", 2013; Castano, "Lightmap Seams", 2017). Edges where light may jump are no seams. Cost: linear in the
// length of the seams; on the calling thread.
SeamReport solve_seams(const Charts& charts, Lightmap& lightmap, const SeamOptions& options = {},
                       const Context& context = {});

// A place of a seam at which two charts are compared: in each chart, in texels of its page.
struct SeamPlace {
  struct On {
    std::uint32_t page = 0;
    Vec2 at{0.0f};
  };
  std::array<On, 2> sides;
};

// Every half texel along every seam.
std::vector<SeamPlace> find_seam_places(const Charts& charts, const Atlas& atlas);

}  // namespace luxel
