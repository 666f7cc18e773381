// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "luxel/classical/stochastic_jacobi.h"
#include "luxel/patch/patch_set.h"
#include "luxel/trace/tracer.h"

namespace luxel::bench {

// Every ray of a whole stochastic Jacobi solve, in the order in which one thread traces them.
std::vector<Ray> rays_of_solve(const PatchSet& patches, const Tracer& tracer,
                               const StochasticJacobiOptions& options, const Context& context);

// Embree with the tracer's settings and no other work: one rtcIntersect1 per ray, over prepared rays.
class BareEmbree {
 public:
  explicit BareEmbree(const PatchSet& patches);
  ~BareEmbree();
  BareEmbree(const BareEmbree&) = delete;
  BareEmbree& operator=(const BareEmbree&) = delete;
  // The number of rays that hit, so that no compiler drops the work.
  std::uint64_t trace(const std::vector<Ray>& rays, const Context& context) const;

 private:
  void* device_;
  void* scene_;
};

}  // namespace luxel::bench
