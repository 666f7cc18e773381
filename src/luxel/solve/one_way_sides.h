// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "luxel/core/workers.h"
#include "luxel/patch/patch_set.h"
#include "luxel/trace/gather_sides.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// Sides whose own rays and the rays of others do not meet alike, so that a ray at one of them must count for
// its sender alone: 1, else 0, [receiver]. These are
//
// - sides with cut-out holes: rays leave a hole, but none ends there;
// - slivers no thicker than the rounding of coordinates, whose rays may start beyond a wall that they touch;
// - sides covered by another that touches them: a short ray back to where an own ray starts meets the other.
//
// Cost: four short rays per side. The same on any number of threads.
std::vector<std::uint8_t> one_way_sides(const PatchSet& patches, const GatherSides& sides,
                                        const Tracer& tracer, const Workers& workers);

}  // namespace luxel
