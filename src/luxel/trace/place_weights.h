// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/trace/look_around.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// Weights of viewpoints that make each place count equally, however large it is and however many of the
// viewpoints stand in it. A place is the set of viewpoints that see each other: a room, or the outside. Views
// that face the open count as one place even where a hill stands between them.
//
// With K(v, w) from 0 (apart) to 1 (in one place) the weights solve sum over w of K(v, w) weight(w) = 1, so
// that a convex room has a total weight of 1, and so has each of two rooms that see little of each other (the
// magnitude of a space: Leinster 2013). A few steps of a multiplicative iteration (Lee and Seung 2001) keep
// them positive and smooth. Their sum is the number of places. Cost: an occlusion ray per pair of viewpoints.
std::vector<float> place_weights(std::span<const Panorama> looks, const Tracer& tracer,
                                 const Context& context);

}  // namespace luxel
