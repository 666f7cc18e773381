// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "luxel/patch/patch_set.h"
#include "luxel/trace/look_around.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// Returns whether light or an eye can be where the look was taken: whether it sees a lamp or a lit sky, or
// one of a few random paths of cosine rays from there meets a lamp, leaves for a lit sky, or comes to where a
// punctual light or one of the eyes is seen. A sealed cavity is not open space, a closed room with a lamp or
// a camera in it is. Reflectances do not matter. Cost: at most a few hundred rays, few where a lamp or the
// sky is seen.
bool is_open_space(const PatchSet& patches, const Tracer& tracer, const Panorama& look,
                   std::span<const Vec3> eyes, std::uint64_t key);

}  // namespace luxel
