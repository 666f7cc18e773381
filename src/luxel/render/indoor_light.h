// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/core/workers.h"
#include "luxel/patch/patch_set.h"
#include "luxel/solution/solution.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// What views of a scene under a sky are judged by in the place of its light. The sky lights houses from
// outside first, and yet they are looked at from inside: so a side counts by how far it is shut in, the
// square of the share of its view that other surfaces fill, where light finds a way to it; what is nearly
// open counts nothing, and what is darker than a hundredth of the sky less in proportion. Where there is next
// to no indoors, all that is lit counts alike. Neighbours count alike.
//
// Gives a Solution with that as irradiance. Deterministic. Cost: 2 rays per patch or a little more.
Solution indoor_light(const PatchSet& patches, const Tracer& tracer, const Workers& workers);

}  // namespace luxel
