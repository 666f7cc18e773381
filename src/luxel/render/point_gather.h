// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "luxel/patch/patch_set.h"
#include "luxel/render/light_paths.h"
#include "luxel/surface/smooth_light.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// The irradiance at a point by a final gather (Reichert 1992): light straight from lamps and sky by shadow
// and cosine rays together, light from elsewhere by the smooth light where the cosine rays end. With it,
// where asked, the light vector (LightPaths::light_vector). Read-only: any number of threads may ask.
class PointGather {
 public:
  // Keeps references. Throws InputError where there is neither lamp nor sky.
  PointGather(const PatchSet& patches, const SmoothLight& light, const Tracer& tracer);

  struct Bounds {
    double error = 0.02;             // of the irradiance, relative
    double least = 0.0;              // W/m²; of darker points the error is of this much
    std::uint32_t max_rays = 4096;   // cosine rays
    bool with_light_vector = false;  // half of the rays then go evenly, not by the cosine
    std::uint32_t min_rays = 64;     // as many at least, before the spread is believed
  };
  struct Result {
    Vec3d irradiance{0.0};                // W/m² by linear sRGB
    Vec3d standard_error{0.0};            // of it; widened as Student's t is for so few replicates
    std::array<Vec3d, 3> light_vector{};  // of each axis, W/m² by linear sRGB; where that is asked for
    std::uint64_t rays = 0;               // traced
    bool reached = false;                 // the error asked for
  };
  // Eight independent replicates of scrambled Sobol points, doubled until their spread is small enough, at
  // least once. The result depends on the arguments alone; key: of the random numbers. More rays go on with
  // those that fewer took.
  Result at(const SurfacePoint& point, const Bounds& bounds, std::uint64_t key) const;

 private:
  const PatchSet& patches_;
  const SmoothLight& light_;
  LightPaths paths_;
  BandColours colours_;
};

// The smooth light of a side at a place, [band], W/m². weights: barycentric, of the corners 1 and 2.
inline double smooth_irradiance(const SmoothLight& light, std::uint32_t side, const Vec2& weights,
                                std::size_t band, std::size_t bands) {
  const auto& values = side % 2 == 0 ? light.irradiance_front : light.irradiance_back;
  const auto& corners = light.corners[side / 2];
  const float weight[] = {1.0f - weights.x - weights.y, weights.x, weights.y};
  double sum = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
    sum += static_cast<double>(weight[k]) * static_cast<double>(values[corners[k] * bands + band]);
  return sum;
}

}  // namespace luxel
