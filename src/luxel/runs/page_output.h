// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "luxel/core/context.h"
#include "luxel/runs/settings.h"
#include "luxel/solution/solution_file.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// Returns the sampling options of the run that made a solution.
SampledOptions sampled_options_of(const Provenance& provenance);

// The contents of a page.
struct PageInput {
  const Baked& baked;
  const SmoothLight& light;
  const std::shared_ptr<const SampleState>&
      samples;  // stored by the run, or null; with them lamps are dimmed by groups
  const FrontAndBack<std::uint8_t>& hidden_sides;
  const Camera& camera;  // where the page begins
};

// Writes the page of a solution, see export_page(). Throws DeviceError.
void write_page(const std::string& output, const PageInput& input, const LookSettings& look,
                const Tracer& tracer, const Context& context);

}  // namespace luxel
