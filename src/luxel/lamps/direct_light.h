// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "luxel/lamps/lamp_rays.h"
#include "luxel/lamps/lamps.h"
#include "luxel/patch/patch_set.h"
#include "luxel/patch/side.h"
#include "luxel/trace/tracer.h"

namespace luxel {

class LampChoices;

// One sample of direct light, as it was taken.
struct ShadowRay {
  std::uint32_t replicate = 0;
  std::uint32_t lamp = 0;     // of Lamps::triangles()
  Vec3 from{0.0f}, to{0.0f};  // m: on the side, and on the lamp
  double given = 0.0;         // W/m² at unit radiance, were nothing between: the sample over its density
  bool seen = false;
};

// One sample of the sky through a portal that sees it.
struct SkySample {
  std::uint32_t replicate = 0;
  std::uint32_t sky_patch = 0;  // see PatchSet::sky_patches
  double irradiance = 0.0;      // at unit radiance, sr: by the luminous transmittance of panes on the way
};

struct DirectOptions {
  std::uint64_t seed = 1;
  std::uint32_t replicates = 8;
  bool low_discrepancy = true;  // Owen-scrambled Sobol points; else independent ones
  bool stratified = true;       // one sequence runs over neighbouring patches; else each has its own
  bool importance = true;       // lamps chosen by what they may give the patch; else by area
  bool control_variate = true;  // closed form of what comes without shadows
  // Adds a cosine ray to each shadow ray, which counts where it meets a lamp. Replaces the control variate:
  // the unshadowed light of lamps has no closed form once it is divided between both kinds of rays.
  bool multiple_importance = false;
};

// Estimates the irradiance of one side of a patch straight from the lamps, by shadow rays. The sky seen
// through a portal is a lamp whose rays continue behind the portal until they meet a surface, which hides the
// sky, or none. Punctual lights and luminaires are sampled apart, one for each ray, in proportion to their
// unshadowed irradiance at that very point (PunctualChoices). Area lamps have constant radiance, so only
// their visibility is sampled. The estimator is
//   sum over lamps of mean(c V) + beta (U - mean(c)),
// with c the unshadowed sample, V its visibility, U the closed form of its mean, and beta the visibility met
// by the other replicates (of that lamp, shrunk towards that of all lamps while samples are few). beta is
// thus independent of its factor, and the estimate is unbiased but for the error of U, about 1e-3; a side
// that sees all of its lamps has U without noise, and one that sees none has 0. A single replicate takes beta
// from itself, which biases it by the order of 1 / samples. A replicate may come out slightly below zero
// where little is seen; the mean over replicates is still an unbiased estimate. Where there are many lamps,
// those that fill a sphere, the facets of a bulb, are sampled as one: a ray goes towards the sphere, uniform
// in solid angle, and counts for the facet that it meets.
class DirectLight {
 public:
  // Keeps references to patches, tracer and lamps.
  DirectLight(const PatchSet& patches, const Tracer& tracer, const Lamps& lamps,
              const DirectOptions& options);

  // Estimates the irradiance by the lamps of each light group, W/m², for each replicate: out[(replicate *
  // groups + group) * bands + band]. Round `round` takes per_replicate new samples per replicate; rounds are
  // independent. position: the patch's place in an order in which neighbours are near. Returns the number of
  // shadow rays, at most replicates * per_replicate (twice that with multiple importance): none where no
  // lamp is above the horizon. Any number of threads may call; the result depends on the arguments alone.
  // Costs 0.1 to 0.4 us per sample beside its shadow ray, and 0.2 us (one lamp) to 8 us (thousands) per
  // side.
  std::uint64_t estimate(SideId side_id, std::uint32_t position, std::uint32_t round,
                         std::uint32_t per_replicate, std::span<float> out) const;

  // The rays behind such an estimate, replicate by replicate: those alone that go to a point of a lamp above
  // the horizon, and cosine rays where they meet a lamp.
  std::vector<ShadowRay> rays_of(SideId side_id, std::uint32_t position, std::uint32_t round,
                                 std::uint32_t per_replicate) const;

  // Those of such an estimate that see the sky through a portal, in the order in which they are taken. The
  // mean over all samples of a replicate is the light of the sky, without the control variate.
  std::vector<SkySample> sky_samples(SideId side_id, std::uint32_t position, std::uint32_t round,
                                     std::uint32_t per_replicate) const;

 private:
  struct Side;
  // Samples of a side to take, as in estimate().
  struct Samples {
    std::uint32_t position, round, per_replicate;
  };
  std::uint64_t add_point_lights(const Side& side, const Samples& samples, std::span<double> sum) const;
  Side start_on(SideId id) const;
  void choose_lamps(LampChoices& choices, const Side& side, std::uint32_t samples) const;
  // Calls body(replicate, term) for every sample; ends: its ends are written there, if anywhere.
  template <typename Body>
  void for_each_term(const Side& side, const LampChoices& choices, const Samples& samples, LampRayEnds* ends,
                     Body body) const;
  // The same with the lamps chosen for the side and this number of samples.
  template <typename Body>
  void for_each_term(SideId side_id, const Samples& samples, LampRayEnds* ends, Body body) const;

  const PatchSet& patches_;
  const Tracer& tracer_;
  const Lamps& lamps_;
  DirectOptions options_;
  LampRays rays_;
};

}  // namespace luxel
