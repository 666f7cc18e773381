// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>

#include "luxel/cli/commands.h"
#include "luxel/cli/console.h"
#include "luxel/cli/light_run.h"
#include "luxel/runs/bake_stages.h"
#include "luxel/runs/lit_scene.h"
#include "luxel/runs/outputs.h"

namespace luxel {
namespace {

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
    drop_bounds_of_quality(options());
    check_outputs();
    settings_.mesh.check_outputs(settings_.run.outputs);
    Console console(settings_.run);
    const Context context({.threads = settings_.run.threads, .ranks = ranks()});
    RunRecord record;
    const auto scene = record.stage("load", [&](auto&) {
      return load_lit_scene(settings_.scene, settings_.look.up, context, console, settings_.light.method);
    });
    if (interrupted()) return stopped_before_light(console);
    keep_files_of(scene);
    const BakeStages stages(settings_, options(), {context, console, record});
    auto start = stages.begin(scene, shows_pictures());
    if (!start) return stopped_before_light(console);
    console.say("scene", describe_scene(file, scene, start->baked.patches));
    return LightRun(settings_, file, options(), {context, console, record}).run(*start, &scene);
  }

 private:
  void check_outputs() const {
    std::vector<NamedOutput> others;
    if (!settings_.keep.checkpoint.empty()) others.push_back({"--checkpoint", settings_.keep.checkpoint});
    check_before_work(settings_.run, settings_.picture, all_kinds, others);
  }

  // Returns whether an output needs the automatic camera.
  bool shows_pictures() const {
    const auto& outputs = settings_.run.outputs;
    return !settings_.picture.is_given() &&
           !std::all_of(outputs.begin(), outputs.end(), [](const auto& o) { return is_solution(o); });
  }

  BakeSettings settings_;
};

}  // namespace

std::unique_ptr<Command> make_bake(CommandLine& line) {
  return std::make_unique<Bake>(
      line.command("bake", "solve the light of a scene; write meshes, pictures or a solution"));
}

}  // namespace luxel
