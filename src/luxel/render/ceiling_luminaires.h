// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/patch/patch_set.h"
#include "luxel/scene/scene.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// Corners of a horizontal square, m; counter-clockwise seen from below, where it emits.
using Luminaire = std::array<Vec3, 4>;

// Places luminaires below the ceilings of a scene without light, up by automatic_up(): one by one, each where
// most points of the open space see it that see none yet, in the middle of these points, until nearly all see
// one. Its edge is a fifth of the clear width there, its distance from the ceiling a fiftieth of that edge.
// The open space is what surfaces enclose, by volume, so that solids count little. None where nothing is
// enclosed. The same for any number of threads. Cost: some 0.3 million rays per luminaire.
std::vector<Luminaire> place_luminaires(const PatchSet& patches, const Tracer& tracer,
                                        const Context& context);

// Appends the squares to the scene as two triangles each, with a material, a group and an object named
// "ceiling luminaire". flux: W per band, of all luminaires; all have the same radiance.
void add_luminaires(const std::vector<Luminaire>& luminaires, const Vec3& flux, Scene& scene);

}  // namespace luxel
