// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "luxel/core/workers.h"
#include "luxel/trace/look_around.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// Weights of viewpoints that make each place count alike, however large it is and however many of the
// viewpoints stand in it. A place is what its viewpoints see of each other: a room, or the outside. Views
// that look out at the open count as one place even where a hill stands between them.
//
// With K(v, w) from 0 (apart) to 1 (in one place) the weights solve sum over w of K(v, w) weight(w) = 1, so a
// convex room, and each of two that see little of each other, weigh 1 in all (the magnitude of a space:
// Leinster 2013). A few steps of a multiplicative iteration (Lee and Seung 2001) keep them positive and
// smooth. They add up to the number of places. Cost: an occlusion ray per pair of looks.
std::vector<float> place_weights(std::span<const Panorama> looks, const Tracer& tracer,
                                 const Workers& workers);

}  // namespace luxel
