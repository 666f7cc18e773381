// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/light_run.h"

#include <numbers>
#include <numeric>
#include <optional>

#include <fmt/format.h>

#include "luxel/cli/commands.h"
#include "luxel/cli/finish.h"
#include "luxel/cli/flags.h"
#include "luxel/cli/outputs.h"
#include "luxel/cli/quantity.h"
#include "luxel/cli/run_report.h"
#include "luxel/cli/step_pictures.h"
#include "luxel/core/hint.h"
#include "luxel/core/memory.h"
#include "luxel/core/work_partition.h"
#include "luxel/lamps/choose_portals.h"
#include "luxel/patch/focus.h"
#include "luxel/scene/band_colours.h"
#include "luxel/solve/relight.h"
#include "luxel/solve/solve_light.h"

namespace luxel {

LightRun::LightRun(const BakeSettings& settings, std::string name, const OptionSet& options,
                   const Context& context, Console& console, RunRecord& record)
    : settings_(settings),
      name_(std::move(name)),
      options_(options),
      context_(context),
      console_(console),
      record_(record) {}

int LightRun::run(Baked& baked, const RefineReport* refined, const std::vector<std::uint32_t>& faces,
                  std::shared_ptr<const SampleState> from, const Scene* scene) {
  StepPictures steps(settings_.light.each_step);
  const SharedWork work(context_);
  const bool is_first = work.process() == 0;  // of several processes, the one that writes
  Checkpoint checkpoint(settings_.keep, is_first);

  // Who sees whom, and what the lamps see.
  console_.announce("hierarchy");
  const auto tracer = record_.stage("hierarchy", [&](auto&) { return Tracer(baked.patches, context_); });
  if (scene != nullptr && from == nullptr)  // else the samples belong to the portals of the file
    find_portals(*scene, tracer, baked.patches);
  console_.announce("lamps");
  const auto views =
      record_.stage("lamps", [&](auto&) { return view_from_lamps(baked.patches, tracer, context_); });
  report_lamps(baked.patches, views);
  if (interrupted()) return stopped_before_light(console_);

  // The light.
  focus_on_picture(baked, tracer);
  foresee(baked.patches, tracer);
  auto hooks = checkpoint.hooks(baked, std::move(from), console_);
  hooks.on_light = [&](const Solution& light, const Progress&) {
    record_.note_light();
    steps.add(light);
  };
  const auto solved = record_.stage("light", [&](auto& stage) {
    auto result = solve(baked, tracer, faces, hooks);
    stage.rays = result.rays;
    return result;
  });
  report_light(baked, solved);
  if (!is_first) return fell_short(solved) ? exit_stopped_early : exit_fine;

  // What was asked for: the work of this process alone.
  const Context alone(context_.threads());
  auto samples = settings_.keep.transport ? checkpoint.state() : nullptr;
  if (samples) {
    console_.announce("light groups");
    samples = record_.stage("light groups", [&](auto&) {
      return with_group_light(baked.patches, tracer, samples, settings_.light.sampled, alone);
    });
    console_.clear_bar();
  }
  const OutputSettings outputs{
      settings_.run, settings_.look, settings_.picture, {&settings_.mesh, scene, settings_.scene.load.scale}};
  const Workplace place{alone, console_, record_};
  auto written = write_outputs(baked, &tracer, outputs, place, {samples.get(), samples});
  for (const auto& file : steps.write(baked, tracer, written.camera, outputs, place))
    written.files.push_back(file);
  checkpoint.finish(baked);
  finish({.command = options_.name(),
          .baked = &baked,
          .solve = &solved,
          .refine = refined,
          .mesh_error_target = settings_.refine.mesh_error,
          .error_target = error_target(),
          .pages = written.pages,
          .camera = written.camera,
          .origin = baked.patches.origin,
          .outputs = written.files,
          .options = &options_,
          .record = &record_},
         settings_.run, console_);
  return written.stopped || fell_short(solved) ? exit_stopped_early : exit_fine;
}

void LightRun::find_portals(const Scene& scene, const Tracer& tracer, PatchSet& patches) {
  console_.announce("portals");
  record_.stage("portals", [&](auto&) {
    set_portals(scene, tracer, patches, context_);
    return 0;
  });
  if (!patches.portals.empty())
    console_.say(
        fmt::format("{} triangles of windows, doors and other openings: the sky is sampled through them",
                    patches.portals.size()));
}

SolveReport LightRun::solve(Baked& baked, const Tracer& tracer, const std::vector<std::uint32_t>& faces,
                            const SolveHooks& hooks) const {
  LightOptions options = settings_.light;
  options.dense.face = faces;
  try {
    return solve_light(baked.patches, tracer, baked.solution, options, hooks, console_.reporting(context_));
  } catch (const InputError& error) {
    throw with_file(name_, error);  // it has no light; the solver knows no file
  }
}

// --focus camera: the picture's camera is the one that counts, where it was given or the scene has none.
void LightRun::focus_on_picture(Baked& baked, const Tracer& tracer) const {
  if (settings_.light.focus != focus_on_camera) return;
  const auto& picture = settings_.picture;
  if (picture.eye || picture.target || baked.patches.cameras.empty())
    baked.patches.cameras = {camera_of(picture, settings_.look, baked, tracer, context_)};
  baked.patches.focuses_on_cameras = true;
}

// Says what a classical method is likely to take, and refuses what would take too much.
void LightRun::foresee(const PatchSet& patches, const Tracer& tracer) const {
  const auto forecast = forecast_light(patches, tracer, settings_.light, context_);
  if (!forecast) return;
  const auto text =
      fmt::format("{} for {} patch sides, about {} and {} of memory", name(settings_.light.method),
                  forecast->sides, rough_duration(forecast->seconds), rough_bytes(forecast->bytes));
  if (is_too_much(*forecast) && !settings_.light.force)
    throw InputError(
        name_,
        fmt::format("--method {} ({} are free): make fewer patches with a larger --max-edge, choose --method "
                    "sampled, or add --force to start anyway",
                    text, rough_bytes(free_memory())));
  console_.say("--method " + text);
}

std::optional<double> LightRun::error_target() const {
  return settings_.light.method == Method::sampled ? std::optional(settings_.light.sampled.error)
                                                   : std::nullopt;
}

// Whether it ended before it was as good as asked. Without a target, a limit is what was asked for.
bool LightRun::fell_short(const SolveReport& solved) const {
  const bool is_at_limit = solved.stop == StopReason::ray_limit || solved.stop == StopReason::time_limit;
  return solved.stop == StopReason::stopped_by_user || (is_at_limit && error_target().value_or(0.0) > 0.0);
}

// Lux of the sky and lumens of each lamp material, so that a wrong unit shows at once, and lamps that light
// nothing.
void LightRun::report_lamps(const PatchSet& patches, const std::vector<LampView>& views) const {
  const auto colours = patches.colours();
  if (patches.has_sky())
    console_.say(fmt::format("sky: {:.4g} lx in the open", std::numbers::pi * colours.lumens(patches.sky)));
  for (const auto& view : views) {
    console_.say(fmt::format("lamp '{}': {:.4g} lm", patches.materials[view.material].name,
                             colours.lumens(view.power)));
    const auto warning = lamp_warning(patches, view);
    if (!warning.text.empty()) warn(console_.log(), with_flags(warning.text, warning.hints));
  }
}

void LightRun::report_light(const Baked& baked, const SolveReport& solved) const {
  console_.say(describe(solved));
  const auto& energy = solved.energy;
  auto power = std::accumulate(energy.emitted.begin(), energy.emitted.end(), 0.0);
  power = std::accumulate(energy.from_sky.begin(), energy.from_sky.end(), power);
  for (std::size_t m = 0; m < solved.back_loss.size(); ++m)
    if (power > 0.0 && solved.back_loss[m] > 0.001 * power)
      warn(console_.log(),
           fmt::format(
               "{:.1f} % of the power of lamps and sky is lost at the backs of one-sided material '{}'",
               100.0 * solved.back_loss[m] / power, baked.patches.materials[m].name));
  if (!fell_short(solved)) return;
  const auto by = solved.stop == StopReason::stopped_by_user
                      ? std::string()
                      : fmt::format(" by the {}", description(solved.stop));
  warn(console_.log(), fmt::format("stopped{}: {}; writing the light there is", by, shortfall(solved)));
}

std::string LightRun::shortfall(const SolveReport& solved) const {
  if (!error_target() && solved.unshot_fraction == 1.0) return "no light had left the lamps yet";
  if (!error_target())
    return fmt::format("{:.1f} % of the emitted power is still unshot", 100.0 * solved.unshot_fraction);
  auto text = solved.seen_error > 0.0
                  ? fmt::format("seen error {:.2g} %", 100.0 * solved.seen_error)
                  : fmt::format("standard error {:.2g} %", 100.0 * solved.predicted_error);
  if (*error_target() > 0.0) text += fmt::format(", requested {:.2g} %", 100.0 * *error_target());
  return text;
}

}  // namespace luxel
