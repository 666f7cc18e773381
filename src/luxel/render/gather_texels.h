// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "luxel/core/context.h"
#include "luxel/patch/patch_set.h"
#include "luxel/render/lightmap.h"
#include "luxel/render/make_lightmap.h"
#include "luxel/solution/solution.h"
#include "luxel/surface/smooth_light.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// Fills the pages of an atlas, each texel with the irradiance at its place (find_texel_places).
//
// First fills all texels from the interpolated light of the patches (SmoothLight), with the standard error of
// the patch. Then, with a tracer, gathers those texels for which that is not accurate enough: where the
// solution's own standard error, or the difference of the patches' means from the smooth light, or a quarter
// of its rise within the patch, exceeds the error target. These are gathered at the texel's point (Reichert
// 1992): light straight from lamps and sky by shadow and cosine rays together, light from elsewhere by the
// smooth light where the cosine rays end. Eight independent replicates of scrambled Sobol points are doubled
// until their standard error is small enough; texels that then still stand out from all texels around them,
// or from the smooth light, take more samples. A texel holds the mean of gathered and smooth light, weighted
// by the inverse of their squared errors.
//
// Directional: every texel holds the gathered light, and its light vector with it; the error target applies
// to the irradiance.
//
// After the monitor's stop in another stage than "texels" there are no pages.
//
// The same bits on any number of threads. Throws MismatchError where the parts are not of one scene or the
// bands have no colour; InputError where an option is out of its range or, gathering, there is no light, or
// directional light is requested without gathering.
TexelReport gather_texels(const LightmapInput& input, const SmoothLight& light, const TexelOptions& options,
                          Lightmap& lightmap, const Context& context);

}  // namespace luxel
