// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "luxel/cli/commands.h"
#include "luxel/cli/console.h"
#include "luxel/runs/bake_settings.h"
#include "luxel/version.h"
#include "luxel/viewer/recent_files.h"
#include "luxel/viewer/run_window.h"

namespace luxel {
namespace {

// `view`: a window that shows a scene while its light is solved, or a solution.
class View final : public Command {
 public:
  explicit View(OptionSet& options) : Command(options) {
    auto& s = settings_;
    s.scene.declare(options, "the mesh (OBJ with MTL, glTF), or a .vtkhdf solution");
    options.make_positionals_optional();
    s.scene.declare_contacts(options);
    s.refine.declare(options);
    s.scene.declare_sky(options);
    s.scene.declare_luminaires(options);
    s.scene.declare_spectra(options);
    s.light.declare(options);
    s.keep.declare_groups(options);
    s.look.declare(options);
    s.picture.declare_view(options);
    options.heading(RunSettings::heading);
    options.add_text("compare", "FILE", compare_, "second solution; the viewer shows the difference from it");
    options.add_output("save", save_, "solution file (.vtkhdf) written when the window closes");
    options.add_output("snapshot", snapshot_, "draw off screen and write this .png at the end");
    options.add_text("script", "FILE", script_, "run the commands of this file; see docs/viewer.md");
    options.add_number("ui-scale", "factor", ui_scale_, 0.0f, 8.0f,
                       "size of text and controls, 2: twice as large; 0: that of the display");
    options.add_flag("off-screen", off_screen_, "draw off screen, for scripts that save pictures");
    options.add_number("threads", "count", s.run.threads, 0, 4096,
                       "threads that solve, at a lower priority than the window; 0: all cores");
    s.light.declare_memory(options);
    s.quality.declare(options);
    options.show_first(
        {"quality", "error", "time", "max-edge", "sky", "eye", "target", "save", "compare", "snapshot"});
    options.set_examples({{"luxel view room.obj", "Shows the light while it is solved."},
                          {"luxel view room.vtkhdf", "Shows a solution."},
                          {"luxel view", "Opens an empty window; drop a scene on it."}});
  }

  int run() override {
    if (settings_.scene.file.empty() && !(snapshot_.empty() && compare_.empty() && save_.empty()))
      throw UsageError("--snapshot, --compare and --save need a scene: expected 'luxel view SCENE'");
    settings_.scene.check();
    settings_.light.check();
    settings_.picture.check();
    drop_bounds_of_quality(options());
    const auto report = run_window(window_settings());
    if (!report.saved.empty()) Console().say("wrote", report.saved);
    return report.interrupted ? exit_stopped_early : exit_fine;
  }

 private:
  WindowSettings window_settings() const {
    const auto& s = settings_;
    WindowSettings window{
        .file = s.scene.file,
        .live = [this](const std::filesystem::path& file) { return session_settings(file); },
        .size = {s.picture.render.width, s.picture.render.height},
        .text_scale = ui_scale_,
        .eye = s.picture.eye,
        .target = s.picture.target,
        .vertical_fov = s.picture.vertical_fov,
        .tone = s.look.tone,
        .off_screen = off_screen_ || !snapshot_.empty(),
        .version = LUXEL_VERSION,
        .is_interrupted = interrupted};
    if (s.look.up != "auto") window.up = s.look.up == "y" ? Vec3(0.0f, 1.0f, 0.0f) : Vec3(0.0f, 0.0f, 1.0f);
    if (!compare_.empty()) window.compare = compare_;
    if (!save_.empty()) window.save = save_;
    if (!snapshot_.empty()) window.snapshot = snapshot_;
    if (!script_.empty()) window.script = read_script(script_);
    if (!window.script && !window.off_screen) window.recent = recent_files_path();
    return window;
  }

  // The same settings as a bake of the file with these options.
  SessionSettings session_settings(const std::filesystem::path& file) const {
    const auto& s = settings_;
    SessionSettings live{.load = s.scene.load_options(),
                         .adds_default_light = s.scene.daylight.adds_default_light(),
                         .patches = s.scene.patches,
                         .refine = {.mesh_error = s.refine.is_on(false) ? s.refine.mesh_error : 0.0,
                                    .max_patches = s.refine.max_patches},
                         .light = s.light,
                         .joins_faces = s.light.joins_faces,
                         .focus = s.light.focus,
                         .groups = s.keep.groups,
                         .smooth = s.look.smooth,
                         .threads = s.run.threads};
    live.sign = [this, file](Provenance& provenance, const LightOptions& light) {
      sign(provenance, file, light);
    };
    live.options_of = [](const Provenance& provenance) {
      BakeSettings bake;
      OptionSet all("bake", "");
      bake.declare(all);
      all.restore(provenance.options);
      return LightOptions(bake.light);
    };
    return live;
  }

  // A saved solution records the command of a bake that reproduces it.
  void sign(Provenance& provenance, const std::filesystem::path& file, const LightOptions& light) const {
    BakeSettings bake;
    OptionSet all("bake", "");
    bake.declare(all);
    all.restore(options().given());
    drop_bounds_of_quality(all);
    bake.scene.file = file.string();
    static_cast<LightOptions&>(bake.light) = light;
    bake.keep.transport = true;
    provenance.program_version = LUXEL_VERSION;
    provenance.command_line = all.as_command(RunSettings::heading);
    provenance.options = all.used_values(RunSettings::heading);
  }

  BakeSettings settings_;
  std::string compare_, save_, snapshot_, script_;
  float ui_scale_ = 0.0f;
  bool off_screen_ = false;
};

}  // namespace

std::unique_ptr<Command> make_view(CommandLine& line) {
  return std::make_unique<View>(line.command("view", "interactive viewer, solving in the background"));
}

}  // namespace luxel
