// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "luxel/core/progress.h"
#include "luxel/core/workers.h"
#include "luxel/trace/tracer.h"

namespace luxel {

struct UnlitOptions {
  bool has_sky = false;                 // what leaves the scene meets light
  std::uint64_t max_rays = 10'000'000;  // begin no more looks beyond
  std::uint64_t seed = 1;
  std::span<const std::uint8_t> is_known_lit = {};  // [side], see side_of(); empty: nothing is known
};

struct Unlit {
  std::vector<std::uint32_t> patches;  // from which no light was found, rising
  std::size_t walks = 0;               // from each side of these
  std::uint64_t rays = 0;
  bool is_whole = true;  // false: stopped
};

// Patches from neither side of which light is found: walks set out from random points of both sides, go on by
// cosine where surfaces reflect, and at every stop look at a lamp chosen by power. What a walk that finds
// light has met on its way is lit too, and to come by a small patch that is known to be lit is to find light.
// An estimate: 32 walks a side of up to four stops may miss a way that is long and narrow, and a patch is lit
// if any part of it is. Most patches take a ray or two. Where much is dark the number of walks is bounded by
// max_rays, but not below 3 a side. Lamps count as lit. The same answer on any number of threads.
Unlit find_unlit(const PatchSet& patches, const Tracer& tracer, const UnlitOptions& options,
                 const Workers& workers, const Monitor& monitor);

}  // namespace luxel
