// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/core/workers.h"
#include "luxel/image/image.h"
#include "luxel/patch/patch_set.h"
#include "luxel/render/lightmap.h"
#include "luxel/render/render.h"
#include "luxel/scene/camera.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// A picture as a reader of the pages sees the scene: where a ray meets a surface, the page is read between
// its texels, times reflectance over pi, textures and all, and a lamp's own light on top; sides that have no
// place are black. What texels and seams are worth is seen there. options and result as in render(). Throws
// MismatchError where the map is not of these patches, or the light is not plain colour (of a spectrum, a
// page holds the colour of what arrives, and no reflectance by wavelength can be put on it).
Image lightmap_picture(const PatchSet& patches, const Lightmap& lightmap, const Tracer& tracer,
                       const Camera& camera, const RenderOptions& options, const Workers& workers);

}  // namespace luxel
