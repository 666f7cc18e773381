// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "luxel/core/context.h"
#include "luxel/image/image.h"
#include "luxel/image/tone.h"
#include "luxel/patch/patch_set.h"
#include "luxel/scene/camera.h"
#include "luxel/surface/smooth_light.h"
#include "luxel/trace/tracer.h"

namespace luxel {

struct Baked;

struct RenderOptions {
  int width = 1280;          ///< pixels
  int height = 960;          ///< pixels
  int samples_per_side = 3;  ///< stratified: 3 means 9 rays per pixel, and 36 where edges pass; at most 64
  std::uint64_t seed = 1;
};

/// A picture of solved light: primary rays only, the smooth light looked up where they meet a surface.
/// Result: radiance, W/(m² sr), linear RGB, none of it negative (in_gamut); the sky's where nothing is seen.
/// Throws MismatchError where the bands have no colour (PatchSet::colours). The same picture on any number of
/// threads. Needs no display. A stop from the monitor leaves the rows not yet done black.
Image render(const PatchSet& patches, const SmoothLight& light, const Tracer& tracer, const Camera& camera,
             const RenderOptions& options, const Context& context = {});

/// A picture with what tone_map() needs for smooth edges and for the sky.
struct Picture {
  Image radiance;  ///< as render() returns it
  /// Pixels whose brightest sample is more than twice as bright as the darkest. Up to 64 parts: equal numbers
  /// of samples of similar luminance, not places within the pixel.
  EdgePixels edges;
  /// The sky as displays show it: bluer and darker towards the zenith, grey below the
  /// horizon. Empty without one.
  SkyPixels sky;
  std::uint64_t rays = 0;  ///< of the camera
};

/// As render(), with the edges. With fewer than 8 samples per side, pixels on edges have samples in twice as
/// many rows and columns, at most 8 by 8. Memory: 12 bytes per sample of a pixel on an edge, 768 at most.
Picture render_picture(const PatchSet& patches, const SmoothLight& light, const Tracer& tracer,
                       const Camera& camera, const RenderOptions& options, const Context& context = {});

/// Adds the sky to a picture made by another method (final gather, paths, lightmap): rays, as many per pixel
/// as the options set, find the part of each pixel that sees it. Edges stay as they are.
Picture with_sky(Image radiance, const PatchSet& patches, const Tracer& tracer, const Camera& camera,
                 const RenderOptions& options, const Context& context = {});

/// Renders a scene baked in one call (solve/bake.h); makes the tracer and the smooth light
/// for this one picture.
Image render(const Baked& baked, const Camera& camera, const RenderOptions& options = {},
             const Context& context = {});

}  // namespace luxel
