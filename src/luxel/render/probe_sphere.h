// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/render/probe_light.h"

namespace luxel {

// The radiance that arrives at a point from all directions, projected on spherical harmonics (harmonics.h).
struct SphereLight {
  std::vector<double> coefficients;  // [band * count + k], W/(m² sr)
  // Standard error of the sampling: the root of the sum over k of the squared standard errors of the
  // luminance coefficients (weights of lux per W/m²), relative to the first one. The solution's own error is
  // not part of it.
  double error = 0.0;
  std::uint64_t rays = 0;  // traced
  bool reached = false;    // whether the error is the requested one
};

// Measures the light from all around at points; the normal of a point matters only where it lies on a
// surface: the light in front of that surface counts. Lamps and portals are sampled by shadow rays, each
// direction by the face of a cube that it passes, so that weights are bounded; suns and other punctual lights
// are exact; evenly distributed rays find sky and surfaces. count: 4 or 9. Empty where the monitor stopped
// the work. The same bits on any number of threads. Cost: up to seven rays per sample.
std::vector<SphereLight> probe_spheres(const SolutionProbe& probe, std::span<const ProbePoint> points,
                                       std::size_t count, const ProbeOptions& options,
                                       const Context& context);

}  // namespace luxel
