// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/bake.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "luxel/cli/bake_settings.h"
#include "luxel/cli/commands.h"
#include "luxel/cli/light_run.h"
#include "luxel/cli/lit_scene.h"
#include "luxel/cli/outputs.h"
#include "luxel/cli/quantity.h"
#include "luxel/cli/run_report.h"
#include "luxel/cli/time_budget.h"
#include "luxel/core/hint.h"
#include "luxel/lamps/choose_portals.h"
#include "luxel/patch/focus.h"
#include "luxel/patch/uncut_faces.h"
#include "luxel/solution/sample_state.h"
#include "luxel/version.h"

namespace luxel {
namespace {

constexpr double after_refinement = 0.6;  // of --time: for the light and the outputs

class Bake final : public Command {
 public:
  explicit Bake(OptionSet& options) : Command(options) {
    settings_.declare(options);
    options.show_first({"output", "quality", "error", "time", "max-edge", "sky", "eye", "target", "width",
                        "height", "exposure", "open"});
    options.set_examples(
        {{"luxel bake room.obj", "Writes room-lit.glb beside the scene: the mesh with its light."},
         {"luxel bake room.obj -o room.png --quality draft --open", "Makes a quick picture and opens it."},
         {"luxel bake room.glb -o lit.glb -o room.png -o room.vtkhdf --error 1%",
          "Writes a mesh, a picture and the solution, from which 'luxel render' and 'luxel export' make "
          "more."}});
  }

  bool takes_ranks() const override { return true; }

  int run() override {
    const auto& file = settings_.scene.file;
    auto& outputs = settings_.run.outputs;
    if (outputs.empty() && settings_.keep.checkpoint.empty()) {
      // Without a file there is no default output: loading it reports the reason.
      if (!std::filesystem::is_regular_file(file)) load_scene(file, settings_.scene.load, {});
      outputs.push_back(default_output(file));
    }
    settings_.check();
    settings_.mesh.check_outputs(settings_.run.outputs);
    Console console(settings_.run);
    const Context context({.threads = settings_.run.threads, .ranks = ranks()});
    RunRecord record;

    // 1. The mesh, or the run that an earlier one kept.
    const auto scene = record.stage(
        "load", [&](auto&) { return load_lit_scene(settings_.scene, settings_.look.up, context, console); });
    if (interrupted()) return stopped_before_light(console);
    if (!scene.cameras.empty()) settings_.picture.of_scene = scene.cameras.front();
    auto kept = run_to_go_on(settings_.keep, fingerprint(scene), options());

    // 2. What it is cut into.
    Baked baked;
    RefineReport refined;
    if (kept) {
      baked = std::move(kept->baked);
      console.say("resumes", fmt::format("{}: after {} rays", settings_.keep.checkpoint,
                                         rough_count(baked.solution.provenance.rays)));
    } else {
      baked.patches = record.stage("patches", [&](auto&) {
        auto patches = settings_.scene.patches;
        if (refines()) patches.target_count = RefineOptions::coarse_patches;
        return make_patches_for_light(scene, patches, console.detailing(context));
      });
      if (interrupted()) return stopped_before_light(console);
      if (shows_pictures() && scene.cameras.empty())
        baked.patches.view =
            record.stage("camera", [&](auto&) { return view_of(scene, settings_.look, context); });
      focus(scene, baked.patches);
      if (refines()) set_portals(scene, baked.patches, context);
      if (refines()) refine(baked, refined, context, record, console);
      if (interrupted() && !is_lit(baked.solution)) return stopped_before_light(console);
      if (settings_.keep.groups_lamps()) set_groups(scene, baked.patches);
      sign(baked.solution);
    }
    console.say("scene", describe_scene(file, scene, baked.patches));

    // 3. The light, and what was asked for.
    const auto faces =
        settings_.light.joins_faces ? uncut_faces(scene, baked.patches) : std::vector<std::uint32_t>();
    auto settings = settings_;
    if (!has_ray_budget(options())) settings.light.sampled.ray_budget = 0;
    return LightRun(settings, file, options(), context, console, record)
        .run(baked, refines() && !kept ? &refined : nullptr, faces, kept ? kept->samples : nullptr, &scene);
  }

 private:
  // A run that is bounded otherwise than by its error, or that names the size of patches, keeps them.
  bool refines() const {
    const auto& light = settings_.light;
    return settings_.refine.is_on(light.method == Method::sampled && light.sampled.rays == 0 &&
                                  light.sampled.seconds == 0.0 &&
                                  settings_.scene.patches.max_edge == automatic_edge);
  }

  // Returns whether an output needs the automatic camera.
  bool shows_pictures() const {
    const auto& outputs = settings_.run.outputs;
    return !settings_.picture.is_given() &&
           !std::all_of(outputs.begin(), outputs.end(), [](const auto& o) { return is_solution(o); });
  }

  // Puts the patches where the light needs them: by the scene alone, so that runs of other seeds or errors
  // have the same mesh and can be merged and compared.
  void refine(Baked& baked, RefineReport& report, const Context& context, RunRecord& record,
              Console& console) const {
    auto options = settings_.refine.options(baked.patches.size());
    options.light.error_measure = settings_.light.sampled.error_measure;
    options.light.memory = settings_.light.sampled.memory;
    options.smooth = settings_.look.smooth;
    TimeBudget budget(settings_.light.sampled.seconds, record);
    budget.reserve(after_refinement * budget.seconds());
    const bool can_stop = true;
    const auto monitored =
        console.reporting(context).with_monitor(budget.stopping(console.monitor(), can_stop));
    record.stage("refine", [&](auto& stage) {
      try {
        baked.patches = refine_to_light(std::move(baked.patches), options, report, monitored);
      } catch (const InputError& error) {
        throw with_file(settings_.scene.file, error);
      }
      for (const auto& level : report.levels) stage.rays += level.rays;
    });
    if (interrupted()) baked.solution = std::move(report.light);
    report.light = {};
    baked.solution.mesh_error = report.mesh_error;
    console.clear_bar();
    console.detail("patches", describe(report, report.stop == RefineStop::stopped_by_user && !interrupted()));
  }

  // A camera is found where the light begins.
  void focus(const Scene& scene, PatchSet& patches) const {
    if (settings_.light.focus == focus_on_camera) return;
    try {
      set_focus(scene, settings_.light.focus, patches);
    } catch (const InputError& error) {
      throw with_file(settings_.scene.file, error);
    }
  }

  void set_groups(const Scene& scene, PatchSet& patches) const {
    try {
      set_light_groups(scene, settings_.keep.groups, patches);
    } catch (const InputError& error) {
      throw with_file(settings_.scene.file, error);
    }
  }

  // Before the light is solved: a checkpoint has it too.
  void sign(Solution& solution) const {
    auto& provenance = solution.provenance;
    provenance.program_version = LUXEL_VERSION;
    provenance.command_line = options().as_command(RunSettings::heading);
    provenance.options = options().used_values(RunSettings::heading);
  }

  BakeSettings settings_;
};

}  // namespace

std::unique_ptr<Command> make_bake(CommandLine& line) {
  return std::make_unique<Bake>(
      line.command("bake", "solve the light of a scene; write meshes, pictures or a solution"));
}

}  // namespace luxel
