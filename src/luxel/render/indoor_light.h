// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/core/context.h"
#include "luxel/patch/patch_set.h"
#include "luxel/solution/solution.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// Importance of sides for the choice of views in a scene under a sky, in place of its light. The sky lights
// houses from outside first, but they are viewed from inside. A side therefore counts by the square of the
// share of its view that other surfaces fill, where light reaches it; sides that are nearly open count
// nothing, and those darker than a tenth of the sky less in proportion, since cavities between walls and
// under roofs have little light. Where there is next to no indoors, all lit sides count equally. Neighbours
// count equally.
//
// Returns a Solution with the importance as irradiance. Deterministic. Cost: 2 rays per patch or a little
// more.
Solution indoor_light(const PatchSet& patches, const Tracer& tracer, const Context& context);

}  // namespace luxel
