// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "luxel/core/context.h"
#include "luxel/image/image.h"
#include "luxel/patch/patch_set.h"
#include "luxel/scene/camera.h"
#include "luxel/surface/smooth_light.h"
#include "luxel/trace/tracer.h"

namespace luxel {

struct Baked;

struct RenderOptions {
  int width = 1280;          ///< pixels
  int height = 960;          ///< pixels
  int samples_per_side = 3;  ///< stratified: 3 means 9 rays per pixel
  std::uint64_t seed = 1;
};

/// A picture of solved light: primary rays only, the smooth light looked up where they meet a surface.
/// Result: radiance, W/(m² sr), linear RGB, none of it negative (in_gamut); the sky's where nothing is seen.
/// Throws MismatchError where the bands have no colour (PatchSet::colours). The same picture on any number of
/// threads. Needs no display. A stop from the monitor leaves the rows not yet done black.
Image render(const PatchSet& patches, const SmoothLight& light, const Tracer& tracer, const Camera& camera,
             const RenderOptions& options, const Context& context = {});

/// The same of a scene baked in one call (solve/bake.h): makes the tracer and the smooth light, for one
/// picture.
Image render(const Baked& baked, const Camera& camera, const RenderOptions& options = {},
             const Context& context = {});

}  // namespace luxel
