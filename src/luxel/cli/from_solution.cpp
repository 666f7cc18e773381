// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <optional>

#include "luxel/cli/commands.h"
#include "luxel/cli/console.h"
#include "luxel/cli/finish.h"
#include "luxel/cli/solved_scene.h"
#include "luxel/runs/outputs.h"
#include "luxel/runs/quality.h"
#include "luxel/runs/settings.h"

namespace luxel {
namespace {

// `render` and `export`: write a solution to files. They differ in the file types they accept and the options
// they show.
class FromSolution final : public Command {
 public:
  FromSolution(OptionSet& options, std::string kinds, bool pictures)
      : Command(options), kinds_(std::move(kinds)) {
    options.set_positional("SOLUTION", file_, "a .vtkhdf file that 'luxel bake' wrote", ".vtkhdf");
    look_.declare(options);
    if (pictures) {
      picture_.declare(options);
      picture_.declare_gather(options);
      picture_.declare_quantity(options);
    } else {
      mesh_.declare(options);
      options.add_text("scene", "FILE", scene_,
                       "the solved scene: a .glb preserves the contents of a glTF file or, with "
                       "--preserve-topology, the triangles of any file");
      look_.declare_title(options);
      picture_.declare_camera(options);
    }
    run_.declare(options, kinds_);
    quality_.declare(options);
    if (pictures) {
      options.show_first({"output", "quality", "eye", "target", "fov", "width", "height", "samples",
                          "exposure", "tone", "quantity", "open"});
      options.set_examples(
          {{"luxel render room.vtkhdf -o room.png", "A picture from a view that Luxel chooses."},
           {"luxel render room.vtkhdf -o door.png --eye 1,1.6,4 --target 1,1.2,0 --exposure 1",
            "From a point, one stop brighter."}});
    } else {
      options.show_first(
          {"output", "quality", "as", "for", "scene", "texels-per-metre", "exposure", "title", "open"});
      options.set_examples({{"luxel export room.vtkhdf -o room.html --open", "A page for any browser."},
                            {"luxel export room.vtkhdf -o room.glb --for godot", "A mesh for Godot."},
                            {"luxel export room.vtkhdf --scene room.glb --as lightmap -o lit.glb",
                             "The scene's own file with lightmaps."}});
    }
  }

  int run() override {
    check_before_work(run_, picture_, kinds_);
    mesh_.check();
    mesh_.check_outputs(run_.outputs);
    if (mesh_.keep_topology && scene_.empty())
      throw UsageError("--preserve-topology needs --scene FILE, the file with the triangles");
    Console console(run_);
    const Context context(run_.threads);
    RunRecord record;
    const auto kept = record.stage("read", [&](auto&) { return read(); });
    restore_from(kept.baked.solution.provenance);
    std::optional<SolvedScene> solved;
    if (!scene_.empty()) {
      solved =
          record.stage("load", [&](auto&) { return load_solved_scene(scene_, file_, kept.baked, console); });
      if (!solved) return stopped_before_light(console);
      keep_files_of(solved->scene);
    }
    if (interrupted()) return stopped_before_light(console);
    MeshWish mesh{&mesh_};
    if (solved) mesh = {&mesh_, &solved->scene, solved->metres_per_unit};
    return write_and_finish(kept.baked, nullptr, options(), {run_, look_, picture_, mesh},
                            {context, console, record}, {nullptr, kept.samples});
  }

 private:
  // HTML viewers dim lamps with the stored transport; no other output needs it.
  StoredRun read() const {
    if (std::any_of(run_.outputs.begin(), run_.outputs.end(), is_page)) return read_stored_run(file_);
    return {read_solution(file_), nullptr};
  }

  // The up axis was set when the solution was made and need not be repeated.
  void restore_from(const Provenance& provenance) {
    if (look_.up != "auto") return;
    for (const auto& [key, value] : provenance.options)
      if (key == "up" && (value == "y" || value == "z")) look_.up = value;
  }

  std::string kinds_;
  std::string file_;
  std::string scene_;
  MeshSettings mesh_;
  LookSettings look_;
  PictureSettings picture_;
  RunSettings run_;
  QualitySettings quality_;
};

}  // namespace

std::unique_ptr<Command> make_render(CommandLine& line) {
  return std::make_unique<FromSolution>(line.command("render", "draw a picture of a solution"), picture_kinds,
                                        true);
}

std::unique_ptr<Command> make_export(CommandLine& line) {
  return std::make_unique<FromSolution>(
      line.command("export", "write a solution as a lit mesh, an HTML page or a copy"), mesh_kinds, false);
}

}  // namespace luxel
