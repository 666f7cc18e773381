// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "luxel/cli/workplace.h"
#include "luxel/runs/outputs.h"

namespace luxel {

// Minimum time of the rest of a run, estimated before its light is solved.
struct OutputEstimate {
  std::optional<Camera> camera = {};  // where outputs need one: found now, and used for them
  double first_light = 0.0;           // s, until the first light of the whole scene
  double outputs = 0.0;               // s, of all outputs, with a margin
};

// Measures a first glance at the light, its smooth surface and a small picture on this machine, and scales
// them to the requested files. Cost: about a tenth of the time that it estimates.
OutputEstimate estimate_outputs(const Baked& baked, const Tracer& tracer, const OutputSettings& settings,
                                const Workplace& place);

}  // namespace luxel
