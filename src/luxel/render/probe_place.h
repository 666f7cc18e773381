// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/core/vector.h"
#include "luxel/lamps/lamp_rays.h"
#include "luxel/patch/patch_set.h"
#include "luxel/solution/solution.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// A place where light is measured.
struct ProbePoint {
  Vec3 position{0.0f};            // m, counted from the patches' origin
  Vec3 normal{0.0f, 0.0f, 1.0f};  // unit: light from the hemisphere around it counts
};

// Returns the distance within which a point counts as lying on a surface: 1 mm, or a ten-thousandth of the
// diagonal of a scene smaller than 10 m.
float surface_tolerance(const PatchSet& patches);

// The start of the rays of a point, and whether it lies on a surface.
//
// A point within `tolerance` of a surface, measured along its normal, is moved onto that surface and off it
// again by the bound on rounding, to the side that the normal points to: a table's top with the normal up,
// its underside with the normal down. Then a point within `tolerance` of a surface beside it, such as the end
// of a line from wall to wall, is moved away from that by the tolerance, to the side that receives more
// light. All other points stay where they are.
struct ProbeOrigin {
  LampRayOrigin rays;
  bool on_surface = false;
};
ProbeOrigin origin_of(const PatchSet& patches, const Solution& solution, const Tracer& tracer,
                      const ProbePoint& point, float tolerance);

}  // namespace luxel
