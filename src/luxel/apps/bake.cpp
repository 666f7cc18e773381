// SPDX-License-Identifier: Apache-2.0
#include <numeric>

#include <fmt/format.h>

#include "luxel/apps/commands.h"
#include "luxel/apps/console.h"
#include "luxel/apps/finish.h"
#include "luxel/apps/outputs.h"
#include "luxel/apps/quantity.h"
#include "luxel/apps/run_report.h"
#include "luxel/apps/settings.h"
#include "luxel/apps/step_pictures.h"
#include "luxel/apps/version.h"
#include "luxel/patch/uncut_faces.h"
#include "luxel/photometry/luminous_efficacy.h"
#include "luxel/report/memory.h"
#include "luxel/solve/forecast.h"
#include "luxel/transport/lamp_check.h"

namespace luxel {
namespace {

class Bake final : public Command {
 public:
  explicit Bake(OptionSet& options) : Command(options) {
    scene_.declare(options);
    scene_.declare_contacts(options);
    refine_.declare(options);
    scene_.declare_sky(options);
    light_.declare(options);
    look_.declare(options);
    picture_.declare(options);
    run_.declare(options, all_kinds);
    light_.declare_run(options);
  }

  int run() override {
    light_.check();
    check_before_work(run_, picture_, all_kinds);
    Console console(run_.quiet);
    const Workers workers(run_.threads);
    RunRecord record;
    StepPictures steps(light_.each_step);

    // 1. The mesh, and what it is cut into.
    const auto scene = record.stage("load", [&](auto&) {
      return load_scene(scene_.file, scene_.load, console.log(), console.monitor());
    });
    if (interrupted()) return stopped_before_light(console);
    Baked baked;
    baked.patches = record.stage("patches", [&](auto&) {
      auto options = scene_.patches;
      if (refine_.is_asked()) options.target_count = RefineSettings::coarse_patches;
      return make_patches(scene, options, console.log(), console.monitor());
    });
    if (interrupted()) return stopped_before_light(console);
    console.say(fmt::format("{}: {} triangles, {} patches, {} materials", scene_.file, scene.triangles.size(),
                            baked.patches.size(), scene.materials.size()));

    RefineReport refined;
    if (refine_.is_asked()) refine(baked, refined, workers, record, console);
    if (interrupted()) return stopped_before_light(console);

    // 2. Who sees whom, and what the lamps see.
    console.announce("hierarchy");
    const auto tracer = record.stage("hierarchy", [&](auto&) { return Tracer(baked.patches, workers); });
    console.announce("lamps");
    const auto views =
        record.stage("lamps", [&](auto&) { return view_from_lamps(baked.patches, tracer, workers); });
    report_lamps(baked.patches, views, console);
    if (interrupted()) return stopped_before_light(console);

    // 3. The light.
    const auto faces = light_.joins_faces ? uncut_faces(scene, baked.patches) : std::vector<std::uint32_t>();
    foresee(baked.patches, tracer, workers, console);
    const auto solved = record.stage("light", [&](auto& stage) {
      auto result =
          solve(baked, tracer, faces, workers, steps.watch(record.watch_for_light(console.monitor())));
      stage.rays = result.rays;
      return result;
    });
    baked.solution.mesh_error = refined.mesh_error;
    auto& provenance = baked.solution.provenance;
    provenance.program_version = program_version;
    provenance.command_line = options().as_command(RunSettings::heading);
    provenance.options = options().used_values(RunSettings::heading);
    report_light(baked, solved, console);

    // 4. What was asked for.
    auto written = write_outputs(baked, &tracer, run_, look_, picture_, workers, console, record);
    for (const auto& file :
         steps.write(baked, tracer, written.camera, look_, picture_, workers, console, record))
      written.files.push_back(file);
    finish({.command = options().name(),
            .baked = &baked,
            .solve = &solved,
            .refine = refine_.is_asked() ? &refined : nullptr,
            .mesh_error_target = refine_.mesh_error,
            .error_target = error_target(),
            .camera = written.camera,
            .origin = baked.patches.origin,
            .outputs = written.files,
            .options = &options(),
            .record = &record},
           run_, console);
    return written.stopped || fell_short(solved) ? exit_stopped_early : exit_fine;
  }

 private:
  // Puts the patches where the light needs them.
  void refine(Baked& baked, RefineReport& report, const Workers& workers, RunRecord& record,
              Console& console) const {
    RefineOptions options{.mesh_error = refine_.mesh_error,
                          .max_patches = refine_.max_patches,
                          .light = light_.sampled,
                          .smooth = look_.smooth};
    record.stage("refine", [&](auto& stage) {
      try {
        baked.patches =
            refine_to_light(std::move(baked.patches), options, report, workers, console.monitor());
      } catch (const InputError& error) {
        throw InputError(scene_.file, error.what());
      }
      for (const auto& level : report.levels) stage.rays += level.rays;
    });
    console.clear_bar();
    console.say(describe(report));
  }

  SolveReport solve(Baked& baked, const Tracer& tracer, const std::vector<std::uint32_t>& faces,
                    const Workers& workers, const Monitor& monitor) const {
    const auto& patches = baked.patches;
    auto& light = baked.solution;
    const auto& method = light_.method;
    try {
      if (method == LightSettings::by_shooting)
        return solve_stochastic_jacobi(patches, tracer, light, light_.shooting, workers, monitor);
      if (method == LightSettings::by_dense) {
        auto options = light_.dense;
        options.face = faces;
        return solve_dense(patches, tracer, light, options, workers, monitor);
      }
      if (method == LightSettings::by_hemicube)
        return solve_hemicube(patches, light, light_.hemicube, workers, monitor);
      if (method == LightSettings::by_lines)
        return solve_lines(patches, tracer, light, light_.lines, workers, monitor);
      return solve_sampled(patches, tracer, light, light_.sampled, workers, monitor);
    } catch (const InputError& error) {
      throw InputError(scene_.file, error.what());  // it has no light; the solver knows no file
    }
  }

  // Says what a classical method is likely to take, and refuses what would take too much.
  void foresee(const PatchSet& patches, const Tracer& tracer, const Workers& workers,
               Console& console) const {
    constexpr double most_seconds = 3600.0;
    constexpr double most_memory = 0.8;  // of what is free
    std::optional<Forecast> forecast;
    if (light_.method == LightSettings::by_dense)
      forecast = forecast_dense(patches, tracer, light_.dense, workers);
    if (light_.method == LightSettings::by_hemicube)
      forecast = forecast_hemicube(patches, light_.hemicube, workers);
    if (light_.method == LightSettings::by_lines)
      forecast = forecast_lines(patches, tracer, light_.lines, workers);
    if (!forecast) return;
    const auto free = free_memory();
    const auto text =
        fmt::format("{} for {} patch sides, about {} and {} of memory", light_.method, forecast->sides,
                    rough_duration(forecast->seconds), rough_bytes(forecast->bytes));
    const bool is_too_much =
        forecast->seconds > most_seconds ||
        (free > 0 && static_cast<double>(forecast->bytes) > most_memory * static_cast<double>(free));
    if (is_too_much && !light_.force)
      throw InputError(
          scene_.file,
          fmt::format(
              "--method {} ({} are free): make fewer patches with a larger --max-edge, choose --method "
              "sampled, or give --force to begin all the same",
              text, rough_bytes(free)));
    console.say("--method " + text);
  }

  std::optional<double> error_target() const {
    return light_.method == LightSettings::by_sampling ? std::optional(light_.sampled.error) : std::nullopt;
  }

  // Whether it ended before it was as good as asked. Without a target, a limit is what was asked for.
  bool fell_short(const SolveReport& solved) const {
    const bool is_at_limit = solved.stop == StopReason::ray_limit || solved.stop == StopReason::time_limit;
    return solved.stop == StopReason::stopped_by_user || (is_at_limit && error_target().value_or(0.0) > 0.0);
  }

  // Lux of the sky and lumens of each lamp material, so that a wrong unit shows at once, and lamps that light
  // nothing.
  static void report_lamps(const PatchSet& patches, const std::vector<LampView>& views, Console& console) {
    if (patches.has_sky())
      console.say(
          fmt::format("sky: {:.4g} lx in the open",
                      lumens(patches.sky_radiosity(0), patches.sky_radiosity(1), patches.sky_radiosity(2))));
    for (const auto& view : views) {
      console.say(fmt::format("lamp '{}': {:.4g} lm", patches.materials[view.material].name,
                              lumens(view.power[0], view.power[1], view.power[2])));
      const auto fault = lamp_fault(patches, view);
      if (!fault.empty()) warn(console.log(), fault);
    }
  }

  void report_light(const Baked& baked, const SolveReport& solved, Console& console) const {
    console.say(describe(solved));
    const auto& energy = solved.energy;
    auto power = std::accumulate(energy.emitted.begin(), energy.emitted.end(), 0.0);
    power = std::accumulate(energy.from_sky.begin(), energy.from_sky.end(), power);
    for (std::size_t m = 0; m < solved.back_loss.size(); ++m)
      if (solved.back_loss[m] > 0.001 * power)
        warn(console.log(),
             fmt::format("{:.1f} % of the emitted power is lost at the backs of one-sided material '{}'",
                         100.0 * solved.back_loss[m] / power, baked.patches.materials[m].name));
    if (!fell_short(solved)) return;
    const auto by = solved.stop == StopReason::stopped_by_user
                        ? std::string()
                        : fmt::format(" by the {}", stop_name(solved.stop));
    warn(console.log(), fmt::format("stopped{}: {}; writing the light there is", by, shortfall(solved)));
  }

  std::string shortfall(const SolveReport& solved) const {
    if (!error_target() && solved.unshot_share == 1.0) return "no light had left the lamps yet";
    if (!error_target())
      return fmt::format("{:.1f} % of the emitted power is still unshot", 100.0 * solved.unshot_share);
    auto text = fmt::format("standard error {:.2g} %", 100.0 * solved.predicted_error);
    if (*error_target() > 0.0) text += fmt::format(", asked for {:.2g} %", 100.0 * *error_target());
    return text;
  }

  SceneSettings scene_;
  RefineSettings refine_;
  LightSettings light_;
  LookSettings look_;
  PictureSettings picture_;
  RunSettings run_;
};

}  // namespace

std::unique_ptr<Command> make_bake(CommandLine& line) {
  return std::make_unique<Bake>(
      line.command("bake", "solve a scene's light and write it: mesh, picture or solution"));
}

}  // namespace luxel
