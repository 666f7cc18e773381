// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/core/context.h"
#include "luxel/image/image.h"
#include "luxel/patch/patch_set.h"
#include "luxel/render/lightmap.h"
#include "luxel/render/render.h"
#include "luxel/scene/camera.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// Renders the scene from its lightmap, as a program that reads the pages would: where a ray meets a surface,
// the page is interpolated between its texels, times reflectance over pi, textures included, plus a lamp's
// own emission; sides without a chart are black. The picture shows the quality of texels and seams. options
// and result as in render(). Throws MismatchError where the map is not of these patches, or the light is not
// plain colour (for spectra, a page holds the colour of the arriving light, to which no reflectance by
// wavelength can be applied).
Image lightmap_picture(const PatchSet& patches, const Lightmap& lightmap, const Tracer& tracer,
                       const Camera& camera, const RenderOptions& options, const Context& context);

}  // namespace luxel
