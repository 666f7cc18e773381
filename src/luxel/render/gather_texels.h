// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "luxel/core/progress.h"
#include "luxel/core/workers.h"
#include "luxel/patch/patch_set.h"
#include "luxel/render/lightmap.h"
#include "luxel/solution/solution.h"
#include "luxel/surface/smooth_light.h"
#include "luxel/trace/tracer.h"

namespace luxel {

struct TexelOptions {
  double error = 0.02;            // relative standard error asked of a texel; 0: no final gather
  std::uint32_t max_rays = 4096;  // cosine rays per texel, and as many to lamps; 64 and more
  bool directional = false;       // the light vector too, and so all texels by final gather
  double dark = 0.1;              // of the mean light: below, the error is of this much
  std::uint64_t seed = 1;
};

// What was done.
struct TexelReport {
  std::uint64_t texels = 0;       // with light of their own
  std::uint64_t gathered = 0;     // of them, by final gather
  std::uint64_t short_of_it = 0;  // of these, with max_rays and still a larger error than asked
  std::uint64_t rays = 0;         // traced
  // By the monitor in the stage "texels": those not reached hold the interpolated light.
  bool stopped = false;
};

// Fills the pages of an atlas, each texel with the irradiance at its place (find_texel_places).
//
// First the light that runs smoothly over the patches (SmoothLight), with the standard error of the patch.
// Then, with a tracer, those texels anew for which that does not do: where the solution's own standard error,
// or what the patches' means miss of the smooth light, or a quarter of the rise of that within the patch, is
// more than the error asked. These are gathered at the very point (Reichert 1992): light straight from lamps
// and sky by shadow and cosine rays together, light from elsewhere by the smooth light where the cosine rays
// end. Eight independent replicates of scrambled Sobol points, doubled until their spread is small enough;
// those that then still stand out from all texels around them go on from more.
//
// Directional: every texel is gathered, and its light vector with it; the error asked is of the irradiance.
//
// After the monitor's stop in another stage than "texels" there are no pages.
//
// The same bits on any number of threads. Throws MismatchError where the parts are not of one scene or the
// bands have no colour; InputError where an option is out of its range or, gathering, there is no light, or
// what is directional cannot be gathered.
TexelReport gather_texels(const PatchSet& patches, const Solution& solution, const SmoothLight& light,
                          const Tracer* tracer, const TexelOptions& options, const Workers& workers,
                          Lightmap& lightmap, const Monitor& monitor = {});

}  // namespace luxel
