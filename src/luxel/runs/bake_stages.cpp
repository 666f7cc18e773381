// SPDX-License-Identifier: Apache-2.0
#include "luxel/runs/bake_stages.h"

#include <fmt/format.h>

#include "luxel/core/hint.h"
#include "luxel/lamps/choose_portals.h"
#include "luxel/patch/focus.h"
#include "luxel/patch/uncut_faces.h"
#include "luxel/runs/picture_camera.h"
#include "luxel/runs/quantity.h"
#include "luxel/runs/refine_text.h"
#include "luxel/solution/sample_state.h"
#include "luxel/solve/bake.h"
#include "luxel/version.h"

namespace luxel {
namespace {

constexpr double after_refinement = 0.6;  // of --time: for the light and the outputs

}  // namespace

std::optional<BakeStart> BakeStages::begin(const Scene& scene, bool needs_view) const {
  const auto& context = place_.context;
  auto& reporter = place_.reporter;
  auto& record = place_.record;
  BakeStart start;
  auto& baked = start.baked;
  if (auto kept = run_to_go_on(settings_.keep, fingerprint(scene), options_)) {
    baked = std::move(kept->baked);
    start.from = std::move(kept->samples);
    reporter.say("resumes", fmt::format("{}: after {} rays", settings_.keep.checkpoint,
                                        rough_count(baked.solution.provenance.rays)));
  } else {
    baked.patches = cut(scene);
    if (reporter.is_interrupted()) return std::nullopt;
    if (settings_.mesh.on_pages()) settings_.mesh.pages.check_texels(baked.patches);
    if (needs_view && scene.cameras.empty())
      baked.patches.view =
          record.stage("camera", [&](auto&) { return view_of(scene, settings_.look, context); });
    focus(scene, baked.patches);
    if (refines()) {
      set_portals(scene, baked.patches, context);
      refine(baked, start.refined.emplace());
    }
    if (reporter.is_interrupted() && !is_lit(baked.solution)) return std::nullopt;
    if (settings_.keep.groups_lamps()) set_groups(scene, baked.patches);
    sign(baked.solution);
  }
  if (settings_.light.joins_faces) start.faces = uncut_faces(scene, baked.patches);
  return start;
}

// A run with a bound other than its error, or with a given size of patches, keeps its patches.
bool BakeStages::refines() const {
  const auto& light = settings_.light;
  return settings_.refine.is_on(light.method == Method::sampled && light.sampled.rays == 0 &&
                                light.sampled.seconds == 0.0 &&
                                settings_.scene.patches.max_edge == automatic_edge);
}

PatchSet BakeStages::cut(const Scene& scene) const {
  return place_.record.stage("patches", [&](auto&) {
    auto patches = settings_.scene.patches;
    if (refines()) patches.target_count = RefineOptions::coarse_patches;
    return make_patches_for_light(scene, patches, place_.reporter.detailing(place_.context));
  });
}

// Refines the patches by the light. Depends on the scene alone, so that runs of other seeds or errors have
// the same mesh and can be merged and compared.
void BakeStages::refine(Baked& baked, RefineReport& report) const {
  const auto& context = place_.context;
  auto& reporter = place_.reporter;
  auto& record = place_.record;
  auto options = settings_.refine.options(baked.patches.size());
  options.light.error_measure = settings_.light.sampled.error_measure;
  options.light.memory = settings_.light.sampled.memory;
  options.later_error = settings_.light.sampled.error;
  options.later_ray_budget = settings_.light.sampled.ray_budget;
  options.smooth = settings_.look.smooth;
  TimeBudget budget(settings_.light.sampled.seconds, record);
  budget.reserve(after_refinement * budget.seconds());
  const bool can_stop = true;
  const auto monitored =
      reporter.reporting(context).with_monitor(budget.stopping(reporter.monitor(), can_stop));
  record.stage("refine", [&](auto& stage) {
    try {
      baked.patches = refine_to_light(std::move(baked.patches), options, report, monitored);
    } catch (const InputError& error) {
      throw with_file(settings_.scene.file, error);
    }
    for (const auto& level : report.levels) stage.rays += level.rays;
  });
  if (reporter.is_interrupted()) baked.solution = std::move(report.light);
  report.light = {};
  baked.solution.mesh_error = report.mesh_error;
  reporter.clear_bar();
  reporter.detail("patches",
                  describe(report, report.stop == RefineStop::stopped_by_user && !reporter.is_interrupted()));
}

// A camera is found where the light begins.
void BakeStages::focus(const Scene& scene, PatchSet& patches) const {
  if (settings_.light.focus == focus_on_camera) return;
  try {
    set_focus(scene, settings_.light.focus, patches);
  } catch (const InputError& error) {
    throw with_file(settings_.scene.file, error);
  }
}

void BakeStages::set_groups(const Scene& scene, PatchSet& patches) const {
  try {
    set_light_groups(scene, settings_.keep.groups, patches);
  } catch (const InputError& error) {
    throw with_file(settings_.scene.file, error);
  }
}

// Set before the light is solved, so that checkpoints contain it.
void BakeStages::sign(Solution& solution) const {
  auto& provenance = solution.provenance;
  provenance.program_version = LUXEL_VERSION;
  provenance.command_line = options_.as_command(RunSettings::heading);
  provenance.options = options_.used_values(RunSettings::heading);
}

}  // namespace luxel
