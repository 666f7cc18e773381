// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "luxel/core/context.h"
#include "luxel/image/image.h"
#include "luxel/patch/patch_set.h"
#include "luxel/scene/camera.h"
#include "luxel/solution/solution.h"
#include "luxel/trace/tracer.h"

namespace luxel {

struct GatherOptions {
  int width = 1280;  // pixels
  int height = 960;  // pixels
  int rays = 64;     // per pixel, 1 to 65536; rounded up to fill a square grid
  std::uint64_t seed = 1;
};

// A final gather (Reichert 1992): for each pixel, rays from the eye; where each meets a surface one cosine
// ray reads the radiosity of the solution at its hit, and one shadow ray samples a lamp. Patches and their
// soft shadows therefore disappear from visible surfaces, and remain only in the indirect light. The
// solution's own direct light at the point is not used, and the emission of lamps that gather rays meet only
// in its share (balance heuristic): light straight from lamps is counted once.
//
// Returns radiance, W/(m² sr), linear RGB (in_gamut); the sky's where no surface is seen. Throws
// MismatchError where the solution is not of these patches or the bands have no colour (PatchSet::colours);
// InputError where there is neither lamp nor sky. The same picture on any number of threads. After a stop
// from the monitor the remaining rows are black.
Image gather_picture(const PatchSet& patches, const Solution& solution, const Tracer& tracer,
                     const Camera& camera, const GatherOptions& options, const Context& context = {});

// The side of the grid that `rays` stands for: 8 for 64.
std::uint32_t gather_grid(int rays);

}  // namespace luxel
