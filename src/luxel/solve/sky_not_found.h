// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "luxel/core/workers.h"
#include "luxel/patch/patch_set.h"
#include "luxel/solve/hit_store.h"

namespace luxel {

// What gaps to the sky that no ray of a unit of receivers has met may do to its irradiance. Where none of N
// rays met the sky, all replicates agree on darkness, but the fraction of rays that meet it may still be some
// 1/N.
//
// That fraction has a gamma distribution of shape 1/2, as Jeffreys' prior has, before rays are traced. Its
// mean is q, what is known of the surroundings: the mean over the unit's first rays of 1 for one that met the
// sky, and else of the fraction of first rays of the unit it met that did. Rays through portals meet no sky
// here: what comes through them is direct light. N rays then leave room for half a ray that met the sky, or
// less where little was found all around, with a variance of (pi L)² q / (N (1 + 2 q N)), L the sky's
// radiance. Under an open sky and in a room whose openings are portals that is nothing, in a dim room with
// few rays it is most of the error.
class SkyNotFound {
 public:
  // hits: after their first round; later rounds change nothing. units: where they begin, receivers, and at
  // the end the number of receivers. Keeps references to patches and hits. Cost: each first ray is read
  // twice, and traced again for that where hits are streamed. Of several ranks, all call this together.
  SkyNotFound(const PatchSet& patches, const HitStore& hits, std::span<const std::uint32_t> units,
              const Workers& workers);

  // Of each receiver's irradiance, [receiver * bands + band], (W/m²)². All 0 without a sky.
  std::vector<float> variance() const;

  std::span<const double> expected() const { return expected_; }  // q, [unit]

 private:
  const PatchSet& patches_;
  const HitStore& hits_;
  std::vector<std::uint32_t> units_;
  std::vector<double> expected_;
};

}  // namespace luxel
