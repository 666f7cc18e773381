// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/light_run.h"

#include <algorithm>
#include <numbers>
#include <numeric>
#include <optional>

#include <fmt/format.h>

#include "luxel/cli/accuracy_text.h"
#include "luxel/cli/commands.h"
#include "luxel/cli/finish.h"
#include "luxel/cli/flags.h"
#include "luxel/cli/output_estimate.h"
#include "luxel/cli/outputs.h"
#include "luxel/cli/quantity.h"
#include "luxel/cli/run_report.h"
#include "luxel/cli/step_pictures.h"
#include "luxel/core/hint.h"
#include "luxel/core/memory.h"
#include "luxel/core/work_partition.h"
#include "luxel/lamps/choose_portals.h"
#include "luxel/lamps/luminaire_check.h"
#include "luxel/patch/focus.h"
#include "luxel/scene/band_colours.h"
#include "luxel/session/words.h"
#include "luxel/solve/relight.h"
#include "luxel/solve/solve_light.h"

namespace luxel {
namespace {

// The fraction of the remaining time, after the solve, for what follows the gathering of texels.
constexpr double end_of_texels = 0.3;
constexpr double min_seconds = 1e-3;  // 0 would be no limit

// As far as a solution tells it.
SolveReport report_of_stopped(Solution& solution) {
  solution.stop = StopReason::stopped_by_user;
  SolveReport report;
  report.stop = solution.stop;
  report.rays = solution.provenance.rays;
  report.predicted_error = solution.predicted_error;
  report.seen_error = solution.seen_error;
  report.error_95th = solution.error_95th;
  report.unshot_fraction = solution.unshot_fraction;
  return report;
}

}  // namespace

LightRun::LightRun(const BakeSettings& settings, std::string name, const OptionSet& options,
                   const Context& context, Console& console, RunRecord& record)
    : settings_(settings),
      name_(std::move(name)),
      options_(options),
      context_(context),
      console_(console),
      record_(record),
      budget_(settings.light.method == Method::sampled ? settings.light.sampled.seconds : 0.0, record) {}

int LightRun::run(Baked& baked, const RefineReport* refined, const std::vector<std::uint32_t>& faces,
                  std::shared_ptr<const SampleState> from, const Scene* scene) {
  StepPictures steps(settings_.light.each_step);
  const SharedWork work(context_);
  const bool is_first = work.process() == 0;  // of several processes, the one that writes
  const Context alone(context_.threads());
  Checkpoint checkpoint(settings_.keep, is_first);

  // Builds the hierarchy, and finds the views of the lamps.
  console_.announce("hierarchy");
  const auto tracer = record_.stage("hierarchy", [&](auto&) { return Tracer(baked.patches, context_); });
  if (scene != nullptr && from == nullptr)  // else the samples belong to the portals of the file
    find_portals(*scene, tracer, baked.patches);
  console_.announce("lamps");
  const auto views =
      record_.stage("lamps", [&](auto&) { return view_from_lamps(baked.patches, tracer, context_); });
  report_lamps(baked.patches, views);
  for (const auto& group : group_faults(baked.patches, find_luminaire_faults(baked.patches, tracer)))
    warn(console_.log(), fmt::format("{}: {}", group.fact, group.remedy));
  // Stopped during refinement: its light, rough as it is, is written.
  const bool is_refined_light = refined != nullptr && interrupted() && is_lit(baked.solution);
  if (interrupted() && !is_refined_light) return stopped_before_light(console_);

  // The light.
  focus_on_picture(baked, tracer);
  foresee(baked.patches, tracer);
  OutputSettings outputs{
      settings_.run, settings_.look, settings_.picture, {&settings_.mesh, scene, settings_.scene.load.scale}};
  const Workplace place{alone, console_, record_, &budget_};
  if (budget_.is_limited()) {
    if (is_first) outputs.camera = reserve_outputs(baked, tracer, outputs, place);
    budget_.reserve(work.broadcast(budget_.reserved()));
  }
  auto hooks = checkpoint.hooks(baked, std::move(from), console_);
  hooks.on_light = [&](const Solution& light, const Progress&) {
    record_.note_light();
    has_light_ = true;
    steps.add(light);
  };
  const auto solved = record_.stage("light", [&](auto& stage) {
    auto result = is_refined_light ? report_of_stopped(baked.solution) : solve(baked, tracer, faces, hooks);
    stage.rays = result.rays;
    return result;
  });
  report_light(baked, solved);
  if (!is_first) return fell_short(solved) ? exit_stopped_early : exit_fine;

  // The requested files, written by this process alone.
  auto samples = settings_.keep.transport ? checkpoint.state() : nullptr;
  if (samples) {
    console_.announce("light groups");
    samples = record_.stage("light groups", [&](auto&) {
      return with_group_light(baked.patches, tracer, samples, settings_.light.sampled, alone);
    });
    console_.clear_bar();
  }
  budget_.reserve(end_of_texels * budget_.left());
  auto written = write_outputs(baked, &tracer, outputs, place, {samples.get(), samples});
  for (const auto& file : steps.write(baked, tracer, written.camera, outputs, place))
    written.files.push_back(file);
  checkpoint.finish(baked);
  finish({.command = options_.name(),
          .baked = &baked,
          .solve = &solved,
          .refine = refined,
          .ended_by_ray_budget = ended_by_ray_budget(solved),
          .mesh_error_target = settings_.refine.options(baked.patches.size()).mesh_error,
          .error_target = error_target(),
          .error_measure = settings_.light.sampled.error_measure,
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
    console_.detail("sky", fmt::format("sampled through {} of windows, doors and other openings",
                                       counted_things(patches.portals.size(), "triangle")));
}

SolveReport LightRun::solve(Baked& baked, const Tracer& tracer, const std::vector<std::uint32_t>& faces,
                            const SolveHooks& hooks) const {
  LightOptions options = settings_.light;
  options.dense.face = faces;
  const SharedWork work(context_);
  if (budget_.is_limited())
    options.sampled.seconds = work.broadcast(std::max(min_seconds, budget_.left() - budget_.reserved()));
  const auto context =
      console_.reporting(context_).with_monitor(budget_.stopping(console_.monitor(), has_light_));
  try {
    auto solved = solve_light(baked.patches, tracer, baked.solution, options, hooks, context);
    if (solved.stop == StopReason::stopped_by_user && !interrupted() && budget_.is_over())
      solved.stop = baked.solution.stop = StopReason::time_limit;
    return solved;
  } catch (const InputError& error) {
    throw with_file(name_, error);  // the scene has no light; the solver does not know its file
  }
}

// Reserves the time of the outputs, and reports a limit that is too short. Returns the camera that was found.
std::optional<Camera> LightRun::reserve_outputs(const Baked& baked, const Tracer& tracer,
                                                const OutputSettings& outputs, const Workplace& place) {
  console_.announce("estimate");
  const auto estimate = estimate_outputs(baked, tracer, outputs, place);
  budget_.reserve(estimate.outputs);
  const auto min = record_.elapsed() + estimate.first_light + estimate.outputs;
  if (min > budget_.seconds())
    warn(console_.log(), fmt::format("--time {} is less than this run needs, at least about {}: it goes on "
                                     "with the first light, from few rays",
                                     as_duration(budget_.seconds()), taken_time(min)));
  return estimate.camera;
}

// --focus camera: uses the picture's camera if it was given or the scene has none.
void LightRun::focus_on_picture(Baked& baked, const Tracer& tracer) const {
  if (settings_.light.focus != focus_on_camera) return;
  const auto& picture = settings_.picture;
  if (picture.eye || picture.target || baked.patches.cameras.empty())
    baked.patches.cameras = {camera_of(picture, settings_.look, baked, tracer, context_)};
  baked.patches.focuses_on_cameras = true;
}

// Reports the expected cost of a classical method, and refuses an excessive one.
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
  console_.say("method", text);
}

std::optional<double> LightRun::error_target() const {
  return settings_.light.method == Method::sampled ? std::optional(settings_.light.sampled.error)
                                                   : std::nullopt;
}

bool LightRun::ended_by_ray_budget(const SolveReport& solved) const {
  return solved.stop == StopReason::ray_limit && settings_.light.sampled.ray_budget > 0;
}

// Whether it ended before it was as good as asked. Without a target, a limit is what was asked for.
bool LightRun::fell_short(const SolveReport& solved) const {
  const bool is_at_limit = (solved.stop == StopReason::ray_limit && !ended_by_ray_budget(solved)) ||
                           solved.stop == StopReason::time_limit;
  return solved.stop == StopReason::stopped_by_user || (is_at_limit && error_target().value_or(0.0) > 0.0);
}

// Reports lux of the sky and lumens of the lamps, which reveals a wrong unit, and lamps that light nothing.
void LightRun::report_lamps(const PatchSet& patches, const std::vector<LampView>& views) const {
  const auto colours = patches.colours();
  double lumens = 0.0;
  std::string lamps;
  for (const auto& view : views) {
    const auto own = colours.lumens(view.power);
    lumens += own;
    lamps += fmt::format("{}lamp '{}': {} lm", lamps.empty() ? "" : "\n",
                         patches.materials[view.material].name, rounded(own));
  }
  constexpr std::size_t max_listed = 3;
  if (views.size() > max_listed && !settings_.run.verbose)
    lamps = fmt::format("{} lamp materials, {} lm together", views.size(), rounded(lumens));
  if (patches.has_sky())
    console_.say("sky", fmt::format("{} lx in the open", rounded(colours.lumens(patches.open_irradiance()))));
  if (!lamps.empty()) console_.say("light", lamps);
  for (const auto& view : views) {
    const auto warning = lamp_warning(patches, view);
    if (!warning.text.empty()) warn(console_.log(), with_flags(warning.text, warning.hints));
  }
}

void LightRun::report_light(const Baked& baked, const SolveReport& solved) const {
  console_.detail("light", describe(solved));
  const auto& energy = solved.energy;
  auto power = std::accumulate(energy.emitted.begin(), energy.emitted.end(), 0.0);
  power = std::accumulate(energy.from_sky.begin(), energy.from_sky.end(), power);
  for (std::size_t m = 0; m < solved.back_loss.size(); ++m)
    if (power > 0.0 && solved.back_loss[m] > 0.001 * power)
      warn(console_.log(),
           fmt::format(
               "{:.1f} % of the power of lamps and sky is lost at the backs of one-sided material '{}'",
               100.0 * solved.back_loss[m] / power, baked.patches.materials[m].name));
  if (fell_short(solved)) warn(console_.log(), stopped_text(solved, error_target()));
}

}  // namespace luxel
