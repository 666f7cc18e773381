// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "luxel/lighting/coefficients.h"
#include "luxel/patch/make_patches.h"
#include "luxel/patch/patch_set.h"
#include "luxel/runs/run_place.h"
#include "luxel/scene/scene.h"
#include "luxel/solve/sampled.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// The solve behind daylight coefficients, and its input.
struct DaylightTransport {
  PatchSet patches;
  std::optional<Tracer> tracer;  // of the patches
  std::shared_ptr<const SampleState> samples;
  SampledOptions options;
  Solution solution;  // the light of the run's sky
  double error = 0.0;
  bool traces_again = false;  // the patches have other panes than the run

  DaylightRun run() const { return {patches, *samples, options, traces_again}; }
};

struct DaylightSolveOptions {
  PatchOptions patches = {};
  double error = 0.05;  // of the light that the sky's patches together give
  std::uint64_t seed = 1;
};

// Solves a scene under a sky of patches alone (lighting/daylight_scene.h). name: of the scene, for messages.
// on_patches: called before the solve; may be empty. Nothing where the run was interrupted.
std::optional<DaylightTransport> solve_daylight(const Scene& scene, const std::string& name,
                                                const DaylightSolveOptions& options,
                                                const std::function<void(const PatchSet&)>& on_patches,
                                                const RunPlace& place);

}  // namespace luxel
