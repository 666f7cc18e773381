// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/core/context.h"
#include "luxel/patch/patch_set.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// Estimated fraction of the surfaces that light of a sky reaches, directly or after reflections: the fronts
// of surfaces, half of them by area and half by triangle. Where the scene has cameras, what those see counts
// instead. 0 where most triangles are reached on neither side, whatever is seen: a room whose walls face
// outwards. Reflectances do not matter. The same for any number of threads. Cost: at most 0.2 million rays.
double sky_reach(const PatchSet& patches, const Tracer& tracer, const Context& context);

}  // namespace luxel
