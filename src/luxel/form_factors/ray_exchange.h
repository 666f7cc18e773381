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

// Area times form factor, m², from a patch side of that area to a polygon it faces, by shadow rays: origins
// uniform on the side, directions uniform in the polygon's solid angle (Arvo 1995). For where so many patches
// stand between that nothing is known but to look. open: the same without them; only what is hidden, or only
// what is seen, is left to chance, whichever varies less. error: three standard errors. 1 us per ray.
Estimate ray_exchange(const Tracer& tracer, const PatchEmitter& from, double area,
                      std::span<const Vec3d> polygon, double open, const RayExchangeOptions& options);

}  // namespace luxel
