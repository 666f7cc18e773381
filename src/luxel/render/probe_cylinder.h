// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/render/probe_light.h"

namespace luxel {

// An illuminance with its errors, as ProbedLight has them.
struct IntegratedLight {
  double illuminance = 0.0;                 // lx
  double sampling_error = 0.0;              // lx, widened as Student's t is
  double solution_error = 0.0;              // lx, see SolutionLight::errors()
  std::vector<double> solution_replicates;  // lx, see ProbedLight

  double standard_error() const;  // of both together, lx
};

// The light on small cylinders at a point.
struct CylinderLight {
  IntegratedLight horizontal;       // on the plane at right angles to the axis, for the modelling index
  IntegratedLight cylindrical;      // mean illuminance of the curved surface of a cylinder
  IntegratedLight semicylindrical;  // of the half of it around `facing`; where requested
  std::uint64_t rays = 0;           // traced
  bool reached = false;             // whether the sampling error of each is the requested one
};

struct CylinderOptions {
  Vec3 axis{0.0f, 0.0f, 1.0f};  // unit: up
  std::optional<Vec3> facing;   // direction that the semi-cylinder faces; its part along the axis is ignored
};

// Measures cylindrical illuminance at points, as integrals of the radiance L over the sphere. With the angle
// t of a direction from the axis and its azimuth a from `facing`:
//   cylindrical      (1 / pi) integral of L sin t, the mean of the vertical illuminances over all azimuths
//   semi-cylindrical (1 / pi) integral of L sin t (1 + cos a), the mean over azimuths up to 90 degrees from
//                    `facing`
//   horizontal       integral of L cos t over the hemisphere around the axis
// The weights are exact. Sampling: see SphereSamples; eight replicates are doubled until each sampling error
// is options.error of its illuminance (or of options.floor). Empty where the monitor stopped the work. The
// same bits on any number of threads.
std::vector<CylinderLight> probe_cylinders(const SolutionProbe& probe, std::span<const ProbePoint> points,
                                           const CylinderOptions& cylinder, const ProbeOptions& options,
                                           const Context& context);

}  // namespace luxel
