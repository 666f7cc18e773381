// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "luxel/core/context.h"
#include "luxel/patch/patch_set.h"
#include "luxel/solution/solution.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// Returns [patch]: 1 where a side is hidden, like the insides of a cupboard and the floor below it: almost no
// light reaches it (hidden_irradiance()), it does not emit, and no viewpoint of place_views() sees it or
// another unlit side that continues it across edges. A dark room is not hidden, since viewpoints see most of
// it. No side is hidden where no open space is found, or where PatchSet::focus restricts the viewpoints.
// Cost: that of place_views(), and a sort of the edges.
FrontAndBack<std::uint8_t> hidden_sides(const PatchSet& patches, const Solution& solution,
                                        const Tracer& tracer, const Context& context);

}  // namespace luxel
