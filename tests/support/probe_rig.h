// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

#include "luxel/patch/make_patches.h"
#include "luxel/render/probe_light.h"

#include "support/lightmap_scenes.h"

namespace luxel::test {

// Patches with a light, and a probe of it.
struct ProbeRig {
  PatchSet patches;
  Solution light;
  Context context{2};
  Tracer tracer;
  SolutionProbe probe;

  ProbeRig(PatchSet of, Solution solution)
      : patches(std::move(of)),
        light(std::move(solution)),
        tracer(patches, context),
        probe(patches, light, tracer, nullptr, context) {}
  // Light that was not solved: the same irradiance on every front.
  ProbeRig(const Scene& scene, float max_edge, float front) : ProbeRig(made(scene, max_edge), front) {}
  ProbeRig(PatchSet of, float front) : ProbeRig(of, even_light(of, front)) {}

  ProbedLight at(const Vec3& position, const Vec3& normal, const ProbeOptions& options = {}) const {
    return probe.at({position, glm::normalize(normal)}, options, options.seed);
  }

 private:
  static PatchSet made(const Scene& scene, float max_edge) {
    return make_patches(scene, {.max_edge = max_edge});
  }
};

// lx of W/m² that is the same in all bands.
inline double lux(double watts) { return 179.0 * watts; }

}  // namespace luxel::test
