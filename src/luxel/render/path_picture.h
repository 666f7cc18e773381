// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "luxel/core/context.h"
#include "luxel/image/image.h"
#include "luxel/render/path_traced.h"
#include "luxel/scene/camera.h"

namespace luxel {

struct PictureSize {
  int width = 1280;  // pixels
  int height = 960;  // pixels
};

struct PathPicture {
  Image radiance;        // W/(m² sr), linear RGB (in_gamut); the sky's where nothing is seen
  Image standard_error;  // of it, widened as Student's t is; errors of different pixels are independent
  StopReason stop = StopReason::nothing_to_do;
  bool complete = false;    // every pixel has light and an error
  std::uint64_t paths = 0;  // per pixel
  std::uint64_t rays = 0;   // traced, without those from the eye
  double error = 0.0;       // of the reflected light: sqrt(sum of variances / sum of squares) over pixels
};

// Reference picture for renderers: for each pixel the mean over its square (a box filter) of the light
// along paths from the eye. Unbiased; the options mean what they do in trace_light(), the error is that of
// the light that surfaces reflect: lamps and sky in view, however bright, do not count. Throws
// MismatchError where the bands have no colour (PatchSet::colours). The same picture on any number of
// threads.
PathPicture trace_picture(const PatchSet& patches, const Tracer& tracer, const Camera& camera,
                          const PictureSize& size, const PathOptions& options, const Context& context = {});

}  // namespace luxel
