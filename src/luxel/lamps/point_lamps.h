// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "luxel/lamps/lamp_choices.h"
#include "luxel/lamps/lamp_rays.h"
#include "luxel/lamps/lamp_tally.h"
#include "luxel/lamps/punctual_choices.h"
#include "luxel/patch/patch_set.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// Estimates the direct irradiance of one point by lamps, replicate by replicate: DirectLight for a point.
// Area lamps and portals are sampled by shadow rays, with their closed form as control variate, so that lamps
// without shadows have no noise, however small they are. Punctual lights are traced once and exact;
// luminaires with an opening are sampled by one more ray each time. The sky beside the portals is not part of
// it. Unbiased.
class PointLamps {
 public:
  // Keeps references to all but the origin. Traces one ray per punctual light above the horizon.
  PointLamps(const PatchSet& patches, const Tracer& tracer, const LampRays& rays, const LampRayOrigin& origin,
             std::uint32_t replicates);

  // Takes one more sample of a replicate. u, v: uniform in [0, 1): for lamps; for luminaires.
  void sample(std::uint32_t replicate, const std::array<float, 2>& u, const std::array<float, 3>& v);
  // Returns whether sample() uses v: whether there are luminaires with an opening, or suns with a disc.
  bool has_openings() const { return !opening_choices_.empty() || !discs_.empty(); }
  // Adds the estimate of each replicate, W/m², to irradiance, [replicate][band]. samples: taken per
  // replicate.
  void add_to(std::span<double> irradiance, std::uint32_t samples);
  std::uint64_t rays() const { return rays_traced_; }

 private:
  void trace_punctual();
  void sample_discs(std::uint32_t replicate, const std::array<float, 3>& v);
  void sample_opening(std::uint32_t replicate, const std::array<float, 3>& v);

  const PatchSet& patches_;
  const Tracer& tracer_;
  const LampRays& rays_;
  LampRayOrigin origin_;
  std::uint32_t replicates_;
  LampChoices choices_;
  std::vector<double> unshadowed_;    // [lamp chosen individually]: W/m² at unit radiance
  std::vector<LampTally> tally_;      // [replicate][lamp chosen individually]
  std::vector<double> seen_of_band_;  // the same of each band; empty without tinted panes
  std::vector<double> branches_;      // [replicate][group][band]: sum over samples of all other lamps, W/m²
  std::vector<double> estimate_;      // the same, of all lamps
  std::vector<double> punctual_;      // [band], W/m²
  PunctualChoices opening_choices_;
  std::vector<std::uint32_t> discs_;  // suns with a disc
  std::vector<double> openings_;      // [replicate][band]: sum over samples, W/m²
  LampEstimates estimates_;
  std::uint64_t rays_traced_ = 0;
};

}  // namespace luxel
