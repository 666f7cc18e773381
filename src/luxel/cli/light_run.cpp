// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/light_run.h"

#include <algorithm>
#include <exception>

#include <fmt/format.h>

#include "luxel/cli/accuracy_text.h"
#include "luxel/cli/commands.h"
#include "luxel/cli/finish.h"
#include "luxel/cli/output_estimate.h"
#include "luxel/cli/run_report.h"
#include "luxel/cli/step_pictures.h"
#include "luxel/core/error.h"
#include "luxel/core/work_partition.h"
#include "luxel/runs/quantity.h"
#include "luxel/solve/seen_measure.h"

namespace luxel {
namespace {

// The fraction of the remaining time, after the solve, for what follows the gathering of texels.
constexpr double end_of_texels = 0.3;

// The seen error in the pictures; 0: there is none, or they show gathered light.
double error_in_pictures(const Written& written, const PictureSettings& settings, const Baked& baked,
                         const Tracer& tracer) {
  const bool has_picture = std::any_of(written.files.begin(), written.files.end(), is_picture);
  if (!has_picture || settings.gather > 0) return 0.0;
  return picture_error_of(baked.patches, tracer, baked.solution, *written.camera);
}

}  // namespace

LightRun::LightRun(const BakeSettings& settings, std::string name, const OptionSet& options,
                   const Workplace& place)
    : settings_(settings),
      name_(std::move(name)),
      options_(options),
      context_(place.context),
      console_(place.console),
      record_(place.record) {}

int LightRun::run(BakeStart& start, const Scene* scene) {
  auto& baked = start.baked;
  const auto* refined = start.refined ? &*start.refined : nullptr;
  StepPictures steps(settings_.light.each_step);
  const SharedWork work(context_);
  const Context alone(context_.threads());
  LightStage stage(settings_, name_, {context_, console_, record_});
  if (!stage.begin(baked, refined, start.from, scene)) return stopped_before_light(console_);

  // The light.
  OutputSettings outputs{
      settings_.run, settings_.look, settings_.picture, {&settings_.mesh, scene, settings_.scene.load.scale}};
  auto& budget = stage.budget();
  const Workplace place{alone, console_, record_, &budget};
  if (budget.is_limited()) {
    if (stage.is_first_process()) outputs.camera = reserve_outputs(baked, stage, outputs, place);
    budget.reserve(work.broadcast(budget.reserved()));
  }
  const auto solved = stage.solve(baked, start.faces, [&](const Solution& light) { steps.add(light); });
  report_light(baked, solved, stage);
  const bool is_short = stage.fell_short(solved);
  if (!stage.is_first_process()) return is_short ? exit_stopped_early : exit_fine;

  // The requested files, written by this process alone.
  const auto samples = stage.samples_to_store(baked);
  budget.reserve(end_of_texels * budget.left());
  // First, since an interrupt ends the outputs. Where its disk is full, the outputs may be on another one.
  std::exception_ptr failure;
  try {
    outputs.light_is_kept = stage.checkpoint().finish(baked);
  } catch (const DeviceError&) {
    failure = std::current_exception();
  }
  auto written = write_outputs(baked, &stage.tracer(), outputs, place, {samples.get(), samples});
  const auto picture_error = error_in_pictures(written, settings_.picture, baked, stage.tracer());
  for (const auto& file : steps.write(baked, stage.tracer(), written.camera, outputs, place)) {
    written.files.push_back(file);
    console_.wrote(file);
  }
  if (failure) std::rethrow_exception(failure);
  finish({.command = options_.name(),
          .baked = &baked,
          .solve = &solved,
          .refine = refined,
          .ended_by_ray_budget = stage.ended_by_ray_budget(solved),
          .mesh_error_target = settings_.refine.options(baked.patches.size()).mesh_error,
          .error_target = stage.error_target(),
          .error_measure = settings_.light.sampled.error_measure,
          .picture_error = picture_error,
          .pages = written.pages,
          .camera = written.camera,
          .origin = baked.patches.origin,
          .outputs = written.files,
          .options = &options_,
          .record = &record_},
         settings_.run, console_);
  return written.stopped || is_short ? exit_stopped_early : exit_fine;
}

// Reserves the time of the outputs, and reports a limit that is too short. Returns the camera that was found.
std::optional<Camera> LightRun::reserve_outputs(const Baked& baked, LightStage& stage,
                                                const OutputSettings& outputs, const Workplace& place) const {
  console_.announce("estimate");
  const auto estimate = estimate_outputs(baked, stage.tracer(), outputs, place);
  auto& budget = stage.budget();
  budget.reserve(estimate.outputs);
  const auto min = record_.elapsed() + estimate.first_light + estimate.outputs;
  if (min > budget.seconds())
    warn(console_.log(), fmt::format("--time {} is less than this run needs, at least about {}: it goes on "
                                     "with the first light, from few rays",
                                     as_duration(budget.seconds()), taken_time(min)));
  return estimate.camera;
}

void LightRun::report_light(const Baked& baked, const SolveReport& solved, const LightStage& stage) const {
  console_.detail("light", describe(solved));
  stage.report_losses(baked, solved);
  if (stage.fell_short(solved)) warn(console_.log(), stopped_text(solved, stage.error_target()));
}

}  // namespace luxel
