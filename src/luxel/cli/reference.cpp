// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <fmt/format.h>

#include "luxel/cli/commands.h"
#include "luxel/cli/console.h"
#include "luxel/cli/finish.h"
#include "luxel/cli/reference_settings.h"
#include "luxel/cli/run_report.h"
#include "luxel/core/ending_of.h"
#include "luxel/core/hint.h"
#include "luxel/lamps/choose_portals.h"
#include "luxel/render/path_picture.h"
#include "luxel/runs/lit_scene.h"
#include "luxel/runs/outputs.h"
#include "luxel/runs/quantity.h"
#include "luxel/runs/settings.h"
#include "luxel/solve/bake.h"
#include "luxel/solve/seen_measure.h"
#include "luxel/version.h"

namespace luxel {
namespace {

class Reference final : public Command {
 public:
  explicit Reference(OptionSet& options) : Command(options) {
    scene_.declare(options, "the mesh (OBJ with MTL, glTF); or a solution (.vtkhdf), for its patches");
    scene_.declare_contacts(options);
    scene_.declare_sky(options);
    scene_.declare_luminaires(options);
    scene_.declare_spectra(options);
    light_.declare(options);
    look_.declare(options);
    picture_.declare_view(options);
    options.add_output("error-picture", error_picture_,
                       "also write the standard error of every pixel: .exr or .hdr");
    run_.declare(options, all_kinds);
    options.show_first({"output", "error", "samples", "bounces-from", "max-edge", "sky", "eye", "target",
                        "width", "height", "open"});
    options.set_examples(
        {{"luxel reference room.obj --error 5% -o truth.vtkhdf", "The light of every patch."},
         {"luxel reference room.obj -o truth.exr --width 320 --height 240", "A picture."}});
  }

  int run() override {
    check();
    Console console(run_);
    const Context context(run_.threads);
    RunRecord record;
    auto baked = read(context, console, record);
    if (interrupted()) return stopped_before_light(console);
    console.announce("hierarchy");
    const auto tracer = record.stage("hierarchy", [&](auto&) { return Tracer(baked.patches, context); });

    RunReport report{.command = options().name(),
                     .origin = baked.patches.origin,
                     .options = &options(),
                     .record = &record};
    // 1. The light of every patch, where a requested file contains it.
    auto meshes = run_;
    std::erase_if(meshes.outputs, is_picture);
    std::optional<SolveReport> solved;
    if (!meshes.outputs.empty()) {
      solved = trace_patches(baked, tracer, context, console, record);
      if (!solved) return stopped_before_light(console);
      report.outputs =
          write_outputs(baked, &tracer, {meshes, look_, picture_}, {context, console, record}).files;
      report.baked = &baked;
      report.solve = &*solved;
    }
    // 2. The picture, by paths of its own.
    bool has_stopped = interrupted();
    if (meshes.outputs.size() < run_.outputs.size()) {
      if (has_stopped) {
        warn(console.log(), "stopped: no picture is written");
      } else {
        report.camera =
            record.stage("camera", [&](auto&) { return camera_of(picture_, look_, baked, tracer, context); });
        report.picture = trace_pictures(baked, tracer, *report.camera, {context, console, record}, report);
        has_stopped = report.picture->stop == StopReason::stopped_by_user;
      }
    }
    if (light_.limits.samples == 0) report.error_target = light_.limits.error;
    report.error_measure = ErrorMeasure::power;
    finish(report, run_, console);
    return has_stopped ? exit_stopped_early : exit_fine;
  }

 private:
  void check() const {
    scene_.check();
    light_.check();
    check_before_work(run_, picture_, all_kinds);
    if (!error_picture_.empty()) {
      expect_ending("--error-picture", error_picture_, ".exr .hdr");
      if (std::none_of(run_.outputs.begin(), run_.outputs.end(), is_picture))
        throw UsageError("--error-picture needs a picture: give -o FILE, ending in one of .png .exr .hdr");
    }
    const SceneSettings as_it_is;
    const auto& l = scene_.load;
    if (is_solution(scene_.file) &&
        (l.scale != as_it_is.load.scale || !l.one_sided.empty() || !l.flip.empty() || !l.glass.empty() ||
         l.max_reflectance != as_it_is.load.max_reflectance || scene_.daylight.sky != "auto" ||
         !scene_.daylight.outside.sun.empty() || !l.spectra.empty() ||
         scene_.patches.max_edge != as_it_is.patches.max_edge))
      throw UsageError(
          "the patches of a solution cannot be changed: --scale, --max-reflectance, --one-sided, --glass, "
          "--flip, --sky, --spectral and --max-edge apply to scenes");
  }

  // A solution keeps its own light for finding a view.
  Baked read(const Context& context, Console& console, RunRecord& record) {
    if (is_solution(scene_.file))
      return record.stage("read", [&](auto&) { return read_solution(scene_.file); });
    const auto scene =
        record.stage("load", [&](auto&) { return load_lit_scene(scene_, look_.up, context, console); });
    if (interrupted()) return {};
    keep_files_of(scene);
    Baked baked;
    baked.patches = record.stage("patches", [&](auto&) {
      return make_patches_for_light(scene, scene_.patches, console.detailing(context));
    });
    if (interrupted()) return {};
    record.stage("portals", [&](auto&) { set_portals(scene, baked.patches, context); });
    if (interrupted()) return {};
    if (scene.cameras.empty() && !picture_.is_given() &&
        std::any_of(run_.outputs.begin(), run_.outputs.end(), is_picture))
      baked.patches.view = view_of(scene, look_, context);
    console.say("scene", describe_scene(scene_.file, scene, baked.patches));
    return baked;
  }

  // The scene has neither lamp nor sky; the library's error names no file.
  template <typename Body>
  auto naming_file(Body body) const {
    try {
      return body();
    } catch (const InputError& error) {
      throw with_file(scene_.file, error);
    }
  }

  // Nothing where it was stopped before every side had light.
  std::optional<SolveReport> trace_patches(Baked& baked, const Tracer& tracer, const Context& context,
                                           Console& console, RunRecord& record) const {
    const auto traced = record.stage("light", [&](auto& stage) {
      baked.solution = {};
      const auto result = naming_file([&] {
        return trace_light(baked.patches, tracer, baked.solution, light_.paths(), console.reporting(context));
      });
      stage.rays = result.rays;
      return result;
    });
    if (!traced.complete) return std::nullopt;
    baked.solution.seen_error = seen_error_of(baked.patches, tracer, baked.solution, context);
    auto& provenance = baked.solution.provenance;
    provenance.program_version = LUXEL_VERSION;
    provenance.command_line = options().as_command(RunSettings::heading);
    provenance.options = options().used_values(RunSettings::heading);
    console.detail(
        "light",
        fmt::format("{} paths per side; {}: standard error {:.2g} % (area-weighted relative RMS over "
                    "patches), below {:.2g} % for 95 % of the lit sides; seen error {:.2g} %",
                    traced.paths, description(traced.stop), 100.0 * traced.predicted_error,
                    100.0 * traced.error_95th, 100.0 * baked.solution.seen_error));
    if (traced.stop == StopReason::stopped_by_user) warn(console.log(), "stopped: writing the light so far");
    SolveReport report;
    report.stop = traced.stop;
    report.rays = traced.rays;
    report.predicted_error = traced.predicted_error;
    report.error_95th = traced.error_95th;
    report.seen_error = baked.solution.seen_error;
    report.energy.emitted = traced.emitted;
    report.energy.from_sky = traced.from_sky;
    report.energy.absorbed = traced.absorbed;
    report.energy.escaped = traced.escaped;
    report.energy.lost_at_backs = traced.lost_at_backs;
    report.energy.in_panes = traced.in_panes;
    report.energy.unshot.assign(traced.emitted.size(), 0.0);
    return report;
  }

  PictureRecord trace_pictures(const Baked& baked, const Tracer& tracer, const Camera& camera,
                               const Workplace& place, RunReport& report) const {
    auto& console = place.console;
    auto& record = place.record;
    const auto traced = record.stage("picture", [&](auto& stage) {
      auto result = naming_file([&] {
        return trace_picture(baked.patches, tracer, camera, {picture_.render.width, picture_.render.height},
                             light_.paths(), console.reporting(place.context));
      });
      stage.rays = result.rays;
      return result;
    });
    const PictureRecord picture{traced.paths, traced.rays, traced.error, traced.stop};
    if (!traced.complete) {
      warn(console.log(), "stopped before every pixel had light: no picture is written");
      return picture;
    }
    console.say("picture", fmt::format("{} paths per pixel, error {} of the reflected light; {}",
                                       traced.paths, error_text(traced.error), description(traced.stop)));
    if (traced.stop == StopReason::stopped_by_user)
      warn(console.log(), "stopped: writing the picture as it is");
    const auto write = [&](const std::string& output, const Picture& shown) {
      record.stage("write " + ending_of(output).substr(1),
                   [&](auto&) { write_picture(output, shown, look_.tone); });
      report.outputs.push_back(output);
      console.wrote(output);
    };
    for (const auto& output : run_.outputs)
      if (is_picture(output))
        write(output,
              with_sky(traced.radiance, baked.patches, tracer, camera, picture_.render, place.context));
    if (!error_picture_.empty()) write(error_picture_, {traced.standard_error, {}, {}});
    return picture;
  }

  SceneSettings scene_;
  ReferenceSettings light_;
  LookSettings look_;
  PictureSettings picture_;
  std::string error_picture_;
  RunSettings run_;
};

}  // namespace

std::unique_ptr<Command> make_reference(CommandLine& line) {
  return std::make_unique<Reference>(
      line.command("reference", "path-traced patches and pictures, as ground truth for comparisons"));
}

}  // namespace luxel
