// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "luxel/patch/patch_set.h"

namespace luxel {

// The largest absolute value of a vertex's coordinates, m: rounding errors of places are proportional to it.
float largest_coordinate(const PatchSet& patches);

// Returns a number per patch, equal for those on one plane: the plane of their input triangles, rounded, so
// that triangles that a modeller put on one plane agree. Where contacts run all the way round a part of a
// plane, the part has a number of its own: the floor in a hut that stands on a larger floor. Cost: linear,
// and a sort of the edges of planes that have contacts.
std::vector<std::uint64_t> plane_parts(const PatchSet& patches);

}  // namespace luxel
