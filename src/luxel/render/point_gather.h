// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "luxel/patch/patch_set.h"
#include "luxel/patch/side.h"
#include "luxel/render/light_paths.h"
#include "luxel/scene/band_colours.h"
#include "luxel/surface/smooth_light.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// Estimates the irradiance at a point by a final gather (Reichert 1992): light straight from lamps and sky by
// shadow and cosine rays together, light from elsewhere by the smooth light where the cosine rays end. Also
// estimates the light vector (LightPaths::light_vector) where requested. Read-only: any number of threads may
// call.
class PointGather {
 public:
  // Keeps references. Throws InputError where there is neither lamp nor sky.
  PointGather(const PatchSet& patches, const SmoothLight& light, const Tracer& tracer);

  struct Limits {
    double error = 0.02;             // of the irradiance, relative
    double least = 0.0;              // W/m²; of darker points the error is of this much
    std::uint32_t max_rays = 4096;   // cosine rays
    bool with_light_vector = false;  // half of the rays then go evenly, not by the cosine
    std::uint32_t min_rays = 64;     // smallest number before the spread is tested
  };
  struct Result {
    Vec3d irradiance{0.0};                // W/m² by linear sRGB
    Vec3d standard_error{0.0};            // of it; widened as Student's t is for so few replicates
    std::array<Vec3d, 3> light_vector{};  // per axis, W/m² by linear sRGB; where requested
    std::uint64_t rays = 0;               // traced
    bool reached = false;                 // whether the error target was reached
  };
  // Eight independent replicates of scrambled Sobol points, doubled until their spread is small enough, at
  // least once. The result depends on the arguments alone; key: of the random numbers. A call with more rays
  // continues the samples of one with fewer.
  Result at(const SurfacePoint& point, const Limits& limits, std::uint64_t key) const;

 private:
  const PatchSet& patches_;
  const SmoothLight& light_;
  LightPaths paths_;
  BandColours colours_;
};

}  // namespace luxel
