// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/patch/patch_set.h"
#include "luxel/render/surface_point.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// The irradiance at single points, W/m², [point][band]: the reference for a field that is drawn over patches.
// Unbiased, by light paths that continue from the points they hit, so the size of patches does not matter. A
// point's normal need not be its patch's: on a round thing made of facets the round one's is true.
//
// paths: per point, rounded up to whole batches of BatchMeans::batch_paths. Answers of different seeds are
// independent; the same input and seed give the same bits on any number of threads. Throws InputError where
// there is no lamp.
std::vector<double> irradiance_at(const PatchSet& patches, const Tracer& tracer,
                                  std::span<const SurfacePoint> points, std::uint64_t paths,
                                  std::uint64_t seed, const Context& context);

}  // namespace luxel
