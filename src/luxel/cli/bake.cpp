// SPDX-License-Identifier: Apache-2.0
#include <filesystem>

#include <fmt/format.h>

#include "luxel/cli/bake_settings.h"
#include "luxel/cli/commands.h"
#include "luxel/cli/light_run.h"
#include "luxel/cli/lit_scene.h"
#include "luxel/cli/outputs.h"
#include "luxel/cli/run_report.h"
#include "luxel/core/hint.h"
#include "luxel/lamps/choose_portals.h"
#include "luxel/patch/focus.h"
#include "luxel/patch/uncut_faces.h"
#include "luxel/solution/sample_state.h"
#include "luxel/version.h"

namespace luxel {
namespace {

class Bake final : public Command {
 public:
  explicit Bake(OptionSet& options) : Command(options) { settings_.declare(options); }

  bool takes_ranks() const override { return true; }

  int run() override {
    const auto& file = settings_.scene.file;
    auto& outputs = settings_.run.outputs;
    if (outputs.empty() && settings_.keep.checkpoint.empty() && std::filesystem::is_regular_file(file))
      outputs.push_back(default_output(file));
    settings_.check();
    settings_.mesh.check_outputs(settings_.run.outputs);
    Console console(settings_.run);
    const Context context({.threads = settings_.run.threads, .ranks = ranks()});
    RunRecord record;

    // 1. The mesh, or the run that an earlier one kept.
    const auto scene =
        record.stage("load", [&](auto&) { return load_lit_scene(settings_.scene, context, console); });
    if (interrupted()) return stopped_before_light(console);
    if (!scene.cameras.empty()) settings_.picture.of_scene = scene.cameras.front();
    auto kept = run_to_go_on(settings_.keep, fingerprint(scene), options());

    // 2. What it is cut into.
    Baked baked;
    RefineReport refined;
    if (kept) {
      baked = std::move(kept->baked);
      console.say(fmt::format("{}: goes on after {} rays", settings_.keep.checkpoint,
                              baked.solution.provenance.rays));
    } else {
      baked.patches = record.stage("patches", [&](auto&) {
        auto patches = settings_.scene.patches;
        if (settings_.refine.is_asked()) patches.target_count = RefineOptions::coarse_patches;
        return make_patches(scene, patches, console.reporting(context));
      });
      if (interrupted()) return stopped_before_light(console);
      if (settings_.refine.is_asked()) set_portals(scene, baked.patches, context);
      if (settings_.refine.is_asked()) refine(baked, refined, context, record, console);
      if (interrupted()) return stopped_before_light(console);
      focus(scene, baked.patches);
      if (settings_.keep.groups_lamps()) set_groups(scene, baked.patches);
      sign(baked.solution);
    }
    console.say(fmt::format("{}: {} triangles, {} patches, {} materials", file, scene.triangles.size(),
                            baked.patches.size(), scene.materials.size()));

    // 3. The light, and what was asked for.
    const auto faces =
        settings_.light.joins_faces ? uncut_faces(scene, baked.patches) : std::vector<std::uint32_t>();
    return LightRun(settings_, file, options(), context, console, record)
        .run(baked, settings_.refine.is_asked() && !kept ? &refined : nullptr, faces,
             kept ? kept->samples : nullptr, &scene);
  }

 private:
  // Puts the patches where the light needs them.
  void refine(Baked& baked, RefineReport& report, const Context& context, RunRecord& record,
              Console& console) const {
    RefineOptions options{.mesh_error = settings_.refine.mesh_error,
                          .max_patches = settings_.refine.max_patches,
                          .light = settings_.light.sampled,
                          .smooth = settings_.look.smooth};
    record.stage("refine", [&](auto& stage) {
      try {
        baked.patches =
            refine_to_light(std::move(baked.patches), options, report, console.reporting(context));
      } catch (const InputError& error) {
        throw with_file(settings_.scene.file, error);
      }
      for (const auto& level : report.levels) stage.rays += level.rays;
    });
    baked.solution.mesh_error = report.mesh_error;
    console.clear_bar();
    console.say(describe(report));
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
