// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/classical/surface_means.h"
#include "luxel/core/workers.h"
#include "luxel/patch/patch_set.h"
#include "luxel/solve/replicate_spread.h"
#include "luxel/trace/gather_sides.h"

namespace luxel {

// Means of direct + gathered light, [replicate][receiver * bands + band], W/m², and their errors from the
// spread of the replicates' own means. At least 2 replicates, not yet smoothed: smoothing keeps the mean of a
// smooth surface, but not of each material on it. The same bits on any number of threads. Cost: 5 ns per
// receiver, replicate and band.
SurfaceMeans measure_surfaces(const PatchSet& patches, const GatherSides& sides, Replicates direct,
                              Replicates gathered, const Workers& workers);

}  // namespace luxel
