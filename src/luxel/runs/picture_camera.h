// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/core/context.h"
#include "luxel/runs/settings.h"
#include "luxel/solution/solution_file.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// Returns the up direction, from the settings or else from the surfaces.
Vec3 up_of(const LookSettings& look, const PatchSet& patches);

// Sets --up of a command that reads a solution to what it was when the solution was made, unless it is given.
void restore_up(const Provenance& provenance, LookSettings& look);

// Finds a view that shows the scene well, for PatchSet::view. It depends on the scene, its light and the up
// direction, not on the size of patches. Cost: a separate mesh, and a million rays.
Camera view_of(const Scene& scene, const LookSettings& look, const Context& context);

// The camera that the settings name, relative to the patches' origin; missing values come from the first
// camera of the patches, from their view, or are found automatically.
Camera camera_of(const PictureSettings& picture, const LookSettings& look, const Baked& baked,
                 const Tracer& tracer, const Context& context);

}  // namespace luxel
