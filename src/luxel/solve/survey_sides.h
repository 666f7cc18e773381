// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/patch/patch_set.h"
#include "luxel/solution/solution.h"
#include "luxel/solve/hit_store.h"
#include "luxel/trace/gather_sides.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// Finds sides where own rays and arriving rays do not correspond, so that a ray at one of them must count for
// its sender only: 1, else 0, [receiver]. These are
//
// - sides with cut-out holes: rays leave a hole, but none ends there;
// - slivers no thicker than the rounding of coordinates, whose rays may start beyond a wall that they touch;
// - sides covered by another that touches them: a short ray back to where an own ray starts meets the other.
//
// Cost: four short rays per side. The same on any number of threads.
std::vector<std::uint8_t> one_way_sides(const PatchSet& patches, const GatherSides& sides,
                                        const Tracer& tracer, const Context& context);

// Returns which receivers any light reaches, estimated from the rays so far: lamps, those that have light in
// a first picture or direct light, those whose rays meet the sky or such a receiver, and so on; and the
// neighbours of these. 1 for lit. The outside of a house is dark, and need not be sampled.
std::vector<std::uint8_t> lit_receivers(const PatchSet& patches, const HitStore& hits,
                                        const Solution& first_picture,
                                        std::span<const std::vector<float>> direct, const Context& context);

// Estimates the variance of irradiance by gaps to the sky that no ray of a unit of receivers has met. Where
// none of N rays met the sky, all replicates agree on darkness, but the fraction of rays that meet it may
// still be some 1/N.
//
// That fraction has a gamma distribution of shape 1/2, as Jeffreys' prior has, before rays are traced. Its
// mean is q, estimated from the surroundings: the mean over the unit's first rays of 1 for one that met the
// sky, and else of the fraction of first rays of the unit it met that did. Rays through portals meet no sky
// here: light through portals is direct light. N rays then leave room for half a ray that met the sky, or
// less where little was found all around, with a variance of (pi L)² q / (N (1 + 2 q N)), L the sky's
// radiance. Under an open sky and in a room whose openings are portals the variance is zero, in a dim room
// with few rays it is most of the error.
class SkyNotFound {
 public:
  // hits: after their first round; later rounds change nothing. units: where they begin, receivers, and at
  // the end the number of receivers. Keeps references to patches and hits. Cost: each first ray is read
  // twice, and traced again for that where hits are streamed. Collective: all processes call it together.
  SkyNotFound(const PatchSet& patches, const HitStore& hits, std::span<const std::uint32_t> units,
              const Context& context);

  // The variance of each receiver's irradiance, [receiver * bands + band], (W/m²)². All 0 without a sky.
  std::vector<float> variance() const;

  std::span<const double> expected() const { return expected_; }  // q, [unit]

 private:
  const PatchSet& patches_;
  const HitStore& hits_;
  std::vector<std::uint32_t> units_;
  std::vector<double> expected_;
};

}  // namespace luxel
