// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "luxel/cli/console.h"
#include "luxel/cli/workplace.h"
#include "luxel/runs/bake_stages.h"
#include "luxel/runs/outputs.h"

namespace luxel {

// From patches to files: the part of a bake that `resume` performs too.
class LightRun {
 public:
  // name: of the input, for messages. options: of the command, for the report. Keeps references.
  LightRun(const BakeSettings& settings, std::string name, const OptionSet& options, const Workplace& place);

  // start: the light is filled in. scene: of the patches, where available. Returns the exit code.
  int run(BakeStart& start, const Scene* scene);

 private:
  std::optional<Camera> reserve_outputs(const Baked& baked, LightStage& stage, const OutputSettings& outputs,
                                        const Workplace& place) const;
  void report_light(const Baked& baked, const SolveReport& solved, const LightStage& stage) const;

  const BakeSettings& settings_;
  std::string name_;
  const OptionSet& options_;
  const Context& context_;
  Console& console_;
  RunRecord& record_;
};

}  // namespace luxel
