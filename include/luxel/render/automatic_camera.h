// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/core/context.h"
#include "luxel/patch/patch_set.h"
#include "luxel/scene/camera.h"
#include "luxel/solution/solution.h"
#include "luxel/trace/tracer.h"

namespace luxel {

/// Returns the up direction: PatchSet::up, which make_patches() fills; unit. For patches without it, such as
/// those of a mesh made by hand, (0,1,0) or (0,0,1): the axis about which more surfaces are level; if
/// undecided, the axis along which lamps shine down; else Y.
Vec3 automatic_up(const PatchSet& patches);

/// The pictures automatic_camera() can judge, as width / height.
inline constexpr float smallest_aspect = 0.01f;
inline constexpr float max_aspect = 100.0f;

/// A view that shows much lit surface, for a scene without a camera: candidate views from inside and from
/// outside are traced at thumbnail size, the best are moved a little, and the best of all is kept (bright,
/// much of the light in view, furnished, little emptiness, no surface close to the eye, the horizon level).
/// Brightness is relative to what a person in the scene's open space sees, so that insides of lamp shades
/// are no attraction.
/// Where the solution has no light, or is empty because nothing was solved yet, every side counts as lit;
/// under a sky sides are weighted by how enclosed they are (indoor_light). The target is at the depth of the
/// view. Deterministic, and the same in any unit of length.
///
/// up: any length, not zero. aspect: width / height, within the bounds above. Throws InputError where they
/// are not, or where there are no patches. Cost: a million rays.
Camera automatic_camera(const PatchSet& patches, const Solution& solution, const Tracer& tracer,
                        const Vec3& up, float aspect = 4.0f / 3.0f, const Context& context = {});

}  // namespace luxel
