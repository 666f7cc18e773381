// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "luxel/lamps/lamp_rays.h"
#include "luxel/lamps/lamps.h"
#include "luxel/lighting/coefficients.h"
#include "luxel/trace/gather_sides.h"

namespace luxel {

// A surface that rays of a point met: its irradiance times reflectance times weight is a part of the point's.
struct PointHit {
  std::uint32_t receiver = 0;  // of GatherSides
  float weight = 0.0f;
  bool is_external = false;  // seen through an opening
};

struct PointHits {
  ProbePoint origin;
  std::vector<PointHit> hits;              // by replicate
  std::vector<std::uint32_t> begins = {};  // [replicate + 1], into hits
  std::uint64_t rays = 0;

  std::span<const PointHit> of_replicate(std::uint32_t r) const {
    return std::span(hits).subspan(begins[r], begins[r + 1] - begins[r]);
  }
};

// The rays of points: by the cosine, and towards the portals of the scene, through which the sky is seen
// (the sky beside them is found by cosine rays). In independent replicates of Owen-scrambled Sobol points.
// Immutable; safe for any number of threads.
class PointRays {
 public:
  // Keeps references to patches, tracer and sides.
  PointRays(const PatchSet& patches, const Tracer& tracer, const GatherSides& sides, std::uint32_t replicates,
            const CoefficientOptions& options);

  // sky: of light straight from the sky, external: of the ground's; both [replicate * sky patches + sky
  // patch], sr, to which is added.
  PointHits trace(const ProbePoint& point, std::uint32_t index, std::span<float> sky,
                  std::span<float> external) const;

 private:
  const PatchSet& patches_;
  const Tracer& tracer_;
  const GatherSides& sides_;
  std::uint32_t replicates_;
  CoefficientOptions options_;
  Lamps lamps_;
  LampRays lamp_rays_;
  Solution dark_;
  float tolerance_;  // m
};

}  // namespace luxel
