// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/lamps/lamp_rays.h"
#include "luxel/lamps/lamps.h"
#include "luxel/patch/patch_set.h"
#include "luxel/render/probe_place.h"
#include "luxel/render/solution_light.h"
#include "luxel/solution/sample_state.h"
#include "luxel/solution/solution.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// Kind of a point.
enum class ProbePlace {
  free,     // in free space
  surface,  // on a surface, and measured on the side that its normal points to
  behind,   // more than half of the rays met backs of one-sided surfaces: inside or behind something
  dark      // no light arrives: inside something solid, or in a sealed space
};

// "free", "surface", "behind", "dark".
const char* name(ProbePlace place);

struct ProbeOptions {
  double error = 0.02;              // standard error of the sampling, relative
  double floor = 1.0;               // lx: darker points have the error of this much
  std::uint32_t max_rays = 262144;  // cosine rays per point
  std::uint64_t seed = 1;
  bool direct = false;  // only light straight from lamps and the sky, without reflections
};

struct ProbedLight {
  ProbePlace place = ProbePlace::free;
  std::vector<double> irradiance;  // [band], W/m²
  double illuminance = 0.0;        // lx
  double sampling_error = 0.0;     // standard error of the probe's own rays, lx; widened as Student's t is
  double solution_error = 0.0;     // of the light that the rays picked up, lx; see SolutionLight::errors()
  std::vector<double> solution_replicates;  // the light that they picked up in each replicate of the
                                            // solution, lx; empty unless the solution stores these
  std::uint64_t rays = 0;                   // traced
  bool reached = false;                     // whether the sampling error is the requested one

  // Standard error of both together, lx.
  double standard_error() const;
};

// Measures the light of a solution at points, with rays of its own; nothing of it takes part in the light.
//
// Direct light: lamps and portals are sampled as the solver samples them (PointLamps), so that small lamps
// are not found by chance; suns and other punctual lights are exact; the sky beside portals comes by cosine
// rays. Indirect light: the cosine rays pick up what the solution's surfaces reflect (final gather, Reichert
// 1992). Eight independent replicates of scrambled Sobol points are doubled until the standard error of the
// illuminance, from their spread, is the requested one, after at least 1024 cosine rays.
//
// The size of the solution's patches is not part of the errors.
class SolutionProbe {
 public:
  // Keeps references. samples: as for SolutionLight.
  SolutionProbe(const PatchSet& patches, const Solution& solution, const Tracer& tracer,
                const SampleState* samples = nullptr, const Context& context = {});

  SolutionProbe(const SolutionProbe&) = delete;
  SolutionProbe& operator=(const SolutionProbe&) = delete;

  const SolutionLight& solved() const { return solved_; }
  const LampRays& lamp_rays() const { return lamp_rays_; }
  const PatchSet& patches() const { return patches_; }
  const Tracer& tracer() const { return tracer_; }
  ProbeOrigin place(const ProbePoint& point) const {
    return origin_of(patches_, solution_, tracer_, point, tolerance_);
  }
  // Radiosity that arrives on a ray from surfaces or the sky, W/m², without what lamps emit and without the
  // sky behind portals, which shadow rays find. hit: what the ray met. Adds to radiosity, [band]. Returns the
  // luminous transmittance of the panes of glass that the ray crosses.
  double add_arriving(const Ray& ray, const Hit& hit, double weight, std::span<double> radiosity) const;

  // The light of one point. key: of the random numbers. Depends on the arguments alone; any number of threads
  // may call. Cost: 2 to 3 us per cosine ray, shadow rays included.
  ProbedLight at(const ProbePoint& point, const ProbeOptions& options, std::uint64_t key) const;

 private:
  const PatchSet& patches_;
  const Solution& solution_;
  const Tracer& tracer_;
  Lamps lamps_;
  LampRays lamp_rays_;
  SolutionLight solved_;
  float tolerance_;  // m
};

// Measures many points; empty where the monitor stopped the work. The same bits on any number of threads; a
// point's light depends on its index and on the seed, not on the other points.
std::vector<ProbedLight> probe_light(const SolutionProbe& probe, std::span<const ProbePoint> points,
                                     const ProbeOptions& options, const Context& context);

}  // namespace luxel
