// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "luxel/patch/patch_set.h"
#include "luxel/transport/hit_store.h"

namespace luxel {

// The variance of each slot's irradiance by gaps to the sky that no ray of its unit has met yet,
// [slot * bands + band], (W/m²)². Where none of N rays met the sky, all replicates agree on darkness, but the
// share of rays that meet it may still be some 1/N. Jeffreys' estimate of that share adds half a ray that met
// the sky to those that did; its variance is more than that of the rays alone by (pi L)² / (2 N²), L the
// sky's radiance. Under an open sky that is nothing, in a dim room with few rays it is most of the error.
// units: where they begin, slots, and at the end the number of slots. All 0 without a sky.
std::vector<float> sky_not_found(const PatchSet& patches, const HitStore& hits,
                                 std::span<const std::uint32_t> units);

}  // namespace luxel
