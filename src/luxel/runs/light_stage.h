// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/lamps/lamp_check.h"
#include "luxel/runs/bake_settings.h"
#include "luxel/runs/checkpoint.h"
#include "luxel/runs/run_place.h"
#include "luxel/solve/refine_to_light.h"
#include "luxel/solve/solve_light.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// Returns whether light has been solved at all, even roughly.
inline bool is_lit(const Solution& solution) { return !solution.irradiance.front.empty(); }

// From patches to light: the part of a bake that a resumed run repeats.
class LightStage {
 public:
  // name: of the input, for messages about missing light.
  LightStage(const BakeSettings& settings, std::string name, const RunPlace& place);

  // Builds the hierarchy, finds portals and the views of the lamps, and reports oddities of these. scene: of
  // the patches, where available. from: state to resume from. refined: the refinement, if there was one;
  // where it was interrupted, its rough light is the result. Returns false where the run was interrupted
  // before there was light. Throws InputError where a classical method would take too long.
  bool begin(Baked& baked, const RefineReport* refined, std::shared_ptr<const SampleState> from,
             const Scene* scene);

  // Solves the light of the patches that it began with. faces: see uncut_faces(), where they count. on_light:
  // receives the light of each step; may be empty.
  SolveReport solve(Baked& baked, const std::vector<std::uint32_t>& faces,
                    const std::function<void(const Solution&)>& on_light = {});

  // Reports materials whose backs take much of the light.
  void report_losses(const Baked& baked, const SolveReport& solved) const;

  // The samples for a solution file, with the light of each lamp group; null where they are not to be stored.
  std::shared_ptr<const SampleState> samples_to_store(const Baked& baked);

  // Requested error; nothing where the method has no such target.
  std::optional<double> error_target() const;
  bool ended_by_ray_budget(const SolveReport& solved) const;
  // Returns whether the solve ended before its requested accuracy. Without a target, a limit counts as the
  // request.
  bool fell_short(const SolveReport& solved) const;

  const Tracer& tracer() const { return *tracer_; }
  std::unique_ptr<Tracer> take_tracer() { return std::move(tracer_); }
  TimeBudget& budget() { return budget_; }
  Checkpoint& checkpoint() { return checkpoint_; }
  bool is_first_process() const { return is_first_; }

 private:
  void find_portals(const Scene& scene, PatchSet& patches);
  void report_lamps(const PatchSet& patches, const std::vector<LampView>& views) const;
  void focus_on_picture(Baked& baked) const;
  void report_cost(const PatchSet& patches) const;
  SolveReport solve_method(Baked& baked, const std::vector<std::uint32_t>& faces,
                           const SolveHooks& hooks) const;

  const BakeSettings& settings_;
  std::string name_;
  const Context& context_;
  Reporter& reporter_;
  RunRecord& record_;
  bool is_first_;  // of several processes, the one that writes
  TimeBudget budget_;
  Checkpoint checkpoint_;
  std::unique_ptr<Tracer> tracer_;
  std::shared_ptr<const SampleState> from_;
  bool is_refined_light_ = false;
  bool has_light_ = false;  // a first picture of the whole scene
};

}  // namespace luxel
