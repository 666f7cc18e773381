// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/solve/sampling.h"

namespace luxel {

// The sky that the sides of a run see through portals, patch of the sky by patch: by the shadow rays of the
// run, which are traced again, since a run keeps only the sum of their light; more where they are few.
// Immutable.
class PortalSky {
 public:
  // The same bits on any number of threads. Cost: those rays, and 8 bytes for each that sees
  // the sky and is the only one of its replicate to see that patch.
  PortalSky(const Sampling& sampling, const Context& context);

  // Returns the irradiance of all sides by the patches [first, first + radiance.size()) of these radiances:
  // [replicate][receiver * patches + patch].
  std::vector<std::vector<float>> irradiance(std::size_t first, std::span<const float> radiance,
                                             const Context& context) const;

 private:
  struct Seen {
    std::uint16_t sky_patch, replicate;
    float irradiance;  // at unit radiance, sr
  };

  std::uint32_t replicates_;
  std::vector<std::vector<Seen>> seen_;  // [receiver], by patch of the sky and replicate
};

}  // namespace luxel
