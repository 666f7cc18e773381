// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "luxel/core/progress.h"
#include "luxel/core/workers.h"
#include "luxel/image/image.h"
#include "luxel/patch/patch_set.h"
#include "luxel/scene/camera.h"
#include "luxel/solution/solution.h"
#include "luxel/trace/tracer.h"

namespace luxel {

struct GatherOptions {
  int width = 1280;  // pixels
  int height = 960;  // pixels
  int rays = 64;     // a pixel, 1 to 65536; as many as fill a square grid, so at least this many
  std::uint64_t seed = 1;
};

// A final gather (Reichert 1992): for each pixel, rays from the eye; where each meets a surface one cosine
// ray reads the radiosity that the solution has at what it meets, and one shadow ray asks a lamp. So patches
// and their soft shadows disappear from what is seen, and remain in the light that arrives from elsewhere.
// The solution's own direct light at the point is not used, nor the emission of lamps that gather rays meet
// but in its share (balance heuristic): light straight from lamps is counted once.
//
// Result: radiance, W/(m² sr), linear RGB (in_gamut); where nothing is seen it is the sky's. Throws
// MismatchError where the solution is not of these patches or the bands have no colour (PatchSet::colours);
// InputError where there is neither lamp nor sky. The same picture on any number of threads. A stop from the
// monitor leaves the rows not yet done black.
Image gather_picture(const PatchSet& patches, const Solution& solution, const Tracer& tracer,
                     const Camera& camera, const GatherOptions& options, const Workers& workers,
                     const Monitor& monitor = {});

// The side of the grid that `rays` stands for: 8 for 64.
std::uint32_t gather_grid(int rays);

}  // namespace luxel
