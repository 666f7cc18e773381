// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/lamps/shadow_receivers.h"
#include "luxel/patch/patch_set.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// Returns whether a shadow lies on the outside of a room: on the back of a triangle from which most rays
// leave the scene, while most rays from the front meet a surface. Walls are often single sheets whose backs
// are not seen from inside, and cuts along lines on the backs are cuts in the fronts, too. False on fronts.
// Cost: 32 rays on backs.
bool is_on_outer_back(const PatchSet& triangles, const Tracer& tracer, const EdgeShadow& shadow);

}  // namespace luxel
