// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "luxel/core/vector.h"
#include "luxel/form_factors/obstructed_exchange.h"
#include "luxel/trace/patch_emitter.h"
#include "luxel/trace/tracer.h"

namespace luxel {

struct RayExchangeOptions {
  double tolerance = 1e-6;        // m², absolute, asked for of three standard errors
  std::uint64_t key = 0;          // of the random numbers (core/address.h)
  std::uint32_t most = 1u << 20;  // rays; past them `error` stays above the tolerance
};

// Estimates area times form factor, m², from a patch side of that area to a polygon it faces, by shadow rays:
// origins uniform on the side, directions uniform in the polygon's solid angle (Arvo 1995). Fallback where
// too many occluders lie between the two for exact clipping. open: the same without them; only the hidden or
// only the visible part is estimated, whichever varies less. error: three standard errors. 1 us per ray.
Estimate ray_exchange(const Tracer& tracer, const PatchEmitter& from, double area,
                      std::span<const Vec3d> polygon, double open, const RayExchangeOptions& options);

}  // namespace luxel
