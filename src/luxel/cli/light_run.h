// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "luxel/cli/bake_settings.h"
#include "luxel/cli/checkpoint.h"
#include "luxel/cli/console.h"
#include "luxel/cli/outputs.h"
#include "luxel/cli/run_record.h"
#include "luxel/cli/time_budget.h"
#include "luxel/core/context.h"
#include "luxel/lamps/lamp_check.h"
#include "luxel/solve/refine_to_light.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// Whether light has been solved at all, even roughly.
inline bool is_lit(const Solution& solution) { return !solution.irradiance.front.empty(); }

// From patches to files: the part of a bake that `resume` does as well.
class LightRun {
 public:
  // name: of what has no light, for messages. options: of the command, for the report. Keeps references.
  LightRun(const BakeSettings& settings, std::string name, const OptionSet& options, const Context& context,
           Console& console, RunRecord& record);

  // baked: patches and provenance; the light is filled in. faces: see uncut_faces(), where they count. from:
  // where to go on. scene: of the patches, where it is at hand. Returns the exit code.
  int run(Baked& baked, const RefineReport* refined, const std::vector<std::uint32_t>& faces,
          std::shared_ptr<const SampleState> from, const Scene* scene);

 private:
  void find_portals(const Scene& scene, const Tracer& tracer, PatchSet& patches);
  SolveReport solve(Baked& baked, const Tracer& tracer, const std::vector<std::uint32_t>& faces,
                    const SolveHooks& hooks) const;
  void focus_on_picture(Baked& baked, const Tracer& tracer) const;
  void foresee(const PatchSet& patches, const Tracer& tracer) const;
  void report_lamps(const PatchSet& patches, const std::vector<LampView>& views) const;
  void report_light(const Baked& baked, const SolveReport& solved) const;
  std::optional<double> error_target() const;
  bool ended_by_ray_budget(const SolveReport& solved) const;
  bool fell_short(const SolveReport& solved) const;
  std::optional<Camera> reserve_outputs(const Baked& baked, const Tracer& tracer,
                                        const OutputSettings& outputs, const Workplace& place);

  const BakeSettings& settings_;
  std::string name_;
  const OptionSet& options_;
  const Context& context_;
  Console& console_;
  RunRecord& record_;
  TimeBudget budget_;
  bool has_light_ = false;  // a first picture of the whole scene
};

}  // namespace luxel
