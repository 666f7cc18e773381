// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/trace/tracer.h"

namespace luxel {

struct UnlitOptions {
  bool has_sky = false;                 // rays that leave the scene find light
  std::uint64_t max_rays = 10'000'000;  // no further paths are started beyond
  std::uint64_t seed = 1;
  std::span<const std::uint8_t> is_known_lit = {};  // [side], see SideId(); empty: nothing is known
};

struct Unlit {
  std::vector<std::uint32_t> patches;  // from which no light was found, ascending
  std::size_t walks = 0;               // from each side of these
  std::uint64_t rays = 0;
  bool is_whole = true;  // false: stopped
};

// Finds patches that light reaches from neither side: random-walk paths start at random points of both sides,
// continue by cosine where surfaces reflect, and at every vertex test a lamp chosen by power. The patches on
// a path that finds light are lit too, and a path that meets a small patch known to be lit finds light. An
// estimate: 32 paths per side of up to four vertices may miss a long and narrow route, and a patch is lit if
// any part of it is. Most patches need a ray or two. Where much is dark the number of paths is bounded by
// max_rays, but not below 3 per side. Lamps count as lit. The same result on any number of threads.
Unlit find_unlit(const PatchSet& patches, const Tracer& tracer, const UnlitOptions& options,
                 const Context& context);

}  // namespace luxel
