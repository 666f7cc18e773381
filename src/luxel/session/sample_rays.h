// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "luxel/session/session_snapshot.h"

namespace luxel {

// The samples from which the light of one side of a patch was estimated. Where the light has its samples,
// these are the rays of the solver, traced again in their original order; for other light, those with
// which a sampled solve would begin. Cost: a ray each, and microseconds; direct_rays() also joins the
// scene's lamps again, milliseconds for thousands of them. Empty where there is no tracer yet, or the
// side gathers no light.

// A cosine ray that gathers the radiosity of other surfaces.
struct GatherRay {
  Vec3 from{0.0f};       // m, on the side
  Vec3 direction{0.0f};  // unit
  Hit hit;               // nothing: it leaves the scene
  std::uint32_t replicate = 0;
};
std::vector<GatherRay> gather_rays(const SessionLight& light, std::uint32_t patch, bool back,
                                   std::size_t most = 256);

// A ray that tests whether a point of a lamp is visible.
struct DirectRay {
  Vec3 from{0.0f}, to{0.0f};  // m, on the side and on the lamp
  bool seen = false;
  std::uint32_t replicate = 0;
};
std::vector<DirectRay> direct_rays(const SessionLight& light, std::uint32_t patch, bool back,
                                   std::size_t most = 256);

}  // namespace luxel
