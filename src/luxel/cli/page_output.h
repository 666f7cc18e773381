// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "luxel/cli/settings.h"
#include "luxel/core/workers.h"
#include "luxel/solution/solution_file.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// How the run that made a solution sampled.
SampledOptions sampled_options_of(const Provenance& provenance);

// The page of a solution, see export_page(). samples: what its run kept, or null; with it lamps are dimmed by
// their groups. camera: where the page begins. Throws DeviceError.
void write_page(const std::string& output, const Baked& baked, const SmoothLight& light,
                const std::shared_ptr<const SampleState>& samples, const Tracer& tracer, const Camera& camera,
                const LookSettings& look, const Workers& workers);

}  // namespace luxel
