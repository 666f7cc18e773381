// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "luxel/patch/patch_set.h"

namespace luxel {

bool has_luminaires(const PatchSet& patches);

// Luminous flux of a luminaire as it is dimmed there, lm; 0 where the bands have no colour.
double luminaire_lumens(const BandPointLight& lamp, const PatchSet& patches);

// Lumens of a group's luminaires after their light was multiplied by these weights, relative to now. A colour
// over this number changes no lumens. 1 where the group has no luminaire that gives light. weight: [band].
double relative_lumens(const PatchSet& patches, std::size_t group, std::span<const float> weight);

}  // namespace luxel
