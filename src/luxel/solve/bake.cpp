// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/bake.h"

#include "luxel/core/context.h"
#include "luxel/trace/tracer.h"

namespace luxel {

Baked bake(const Scene& scene, const BakeOptions& options, const Context& context) {
  check_scene(scene);
  Baked baked{make_patches(scene, options.patches, context), {}};
  if (baked.patches.size() == 0) return baked;
  const Tracer tracer(baked.patches, context);
  solve_sampled(baked.patches, tracer, baked.solution, options.light, context);
  return baked;
}

}  // namespace luxel
