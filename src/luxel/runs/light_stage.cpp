// SPDX-License-Identifier: Apache-2.0
#include "luxel/runs/light_stage.h"

#include <algorithm>
#include <array>
#include <numeric>

#include <fmt/format.h>

#include "luxel/core/hint.h"
#include "luxel/core/memory.h"
#include "luxel/core/work_partition.h"
#include "luxel/lamps/choose_portals.h"
#include "luxel/lamps/luminaire_check.h"
#include "luxel/patch/focus.h"
#include "luxel/runs/picture_camera.h"
#include "luxel/runs/quantity.h"
#include "luxel/scene/band_colours.h"
#include "luxel/session/words.h"
#include "luxel/solve/mesh_estimate.h"
#include "luxel/solve/relight.h"

namespace luxel {
namespace {

constexpr double min_seconds = 1e-3;  // 0 would be no limit

// As far as a solution records it.
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

LightStage::LightStage(const BakeSettings& settings, std::string name, const RunPlace& place)
    : settings_(settings),
      name_(std::move(name)),
      context_(place.context),
      reporter_(place.reporter),
      record_(place.record),
      is_first_(SharedWork(context_).process() == 0),
      budget_(settings.light.method == Method::sampled ? settings.light.sampled.seconds : 0.0, record_),
      checkpoint_(settings.keep, is_first_) {}

bool LightStage::begin(Baked& baked, const RefineReport* refined, std::shared_ptr<const SampleState> from,
                       const Scene* scene) {
  from_ = std::move(from);
  reporter_.announce("hierarchy");
  tracer_ =
      record_.stage("hierarchy", [&](auto&) { return std::make_unique<Tracer>(baked.patches, context_); });
  if (scene != nullptr && from_ == nullptr)  // else the samples belong to the portals of the file
    find_portals(*scene, baked.patches);
  reporter_.announce("lamps");
  const auto views =
      record_.stage("lamps", [&](auto&) { return view_from_lamps(baked.patches, *tracer_, context_); });
  report_lamps(baked.patches, views);
  for (const auto& group : group_faults(baked.patches, find_luminaire_faults(baked.patches, *tracer_)))
    warn(reporter_.log(), fmt::format("{}: {}", group.fact, group.remedy));
  is_refined_light_ = refined != nullptr && reporter_.is_interrupted() && is_lit(baked.solution);
  if (reporter_.is_interrupted() && !is_refined_light_) return false;
  focus_on_picture(baked);
  report_cost(baked.patches);
  return true;
}

SolveReport LightStage::solve(Baked& baked, const std::vector<std::uint32_t>& faces,
                              const std::function<void(const Solution&)>& on_light) {
  auto hooks = checkpoint_.hooks(baked, std::move(from_), reporter_);
  hooks.on_light = [&](const Solution& light, const Progress&) {
    record_.note_light();
    has_light_ = true;
    if (on_light) on_light(light);
  };
  std::array<Solution, 2> halves;
  if (baked.solution.mesh_error > 0.0) hooks.halves = &halves;
  return record_.stage("light", [&](auto& stage) {
    auto result = is_refined_light_ ? report_of_stopped(baked.solution) : solve_method(baked, faces, hooks);
    stage.rays = result.rays;
    // The refinement's own estimate is noisier, and too low where it decided about the cuts.
    if (!halves[0].irradiance.front.empty())
      baked.solution.mesh_error =
          mesh_error_of(baked.patches, *tracer_, std::move(halves), settings_.light.sampled.error_measure,
                        settings_.look.smooth, context_);
    return result;
  });
}

SolveReport LightStage::solve_method(Baked& baked, const std::vector<std::uint32_t>& faces,
                                     const SolveHooks& hooks) const {
  LightOptions options = settings_.light;
  options.dense.face = faces;
  const SharedWork work(context_);
  if (budget_.is_limited())
    options.sampled.seconds = work.broadcast(std::max(min_seconds, budget_.left() - budget_.reserved()));
  const auto context =
      reporter_.reporting(context_).with_monitor(budget_.stopping(reporter_.monitor(), has_light_));
  try {
    auto solved = solve_light(baked.patches, *tracer_, baked.solution, options, hooks, context);
    if (solved.stop == StopReason::stopped_by_user && !reporter_.is_interrupted() && budget_.is_over())
      solved.stop = baked.solution.stop = StopReason::time_limit;
    return solved;
  } catch (const InputError& error) {
    throw with_file(name_, error);  // the scene has no light; the error lacks its file
  }
}

std::shared_ptr<const SampleState> LightStage::samples_to_store(const Baked& baked) {
  if (!settings_.keep.transport || !checkpoint_.state()) return nullptr;
  reporter_.announce("light groups");
  const Context alone(context_.threads());
  auto samples = record_.stage("light groups", [&](auto&) {
    return with_group_light(baked.patches, *tracer_, checkpoint_.state(), settings_.light.sampled, alone);
  });
  reporter_.clear_bar();
  return samples;
}

void LightStage::find_portals(const Scene& scene, PatchSet& patches) {
  reporter_.announce("portals");
  record_.stage("portals", [&](auto&) {
    set_portals(scene, *tracer_, patches, context_);
    return 0;
  });
  if (!patches.portals.empty())
    reporter_.detail("sky", fmt::format("sampled through {} of windows, doors and other openings",
                                        counted_things(patches.portals.size(), "triangle")));
}

// --focus camera: uses the picture's camera if it was given or the scene has none.
void LightStage::focus_on_picture(Baked& baked) const {
  if (settings_.light.focus != focus_on_camera) return;
  const auto& picture = settings_.picture;
  if (picture.eye || picture.target || baked.patches.cameras.empty())
    baked.patches.cameras = {camera_of(picture, settings_.look, baked, *tracer_, context_)};
  baked.patches.focuses_on_cameras = true;
}

// Reports the expected cost of a classical method, and refuses an excessive one.
void LightStage::report_cost(const PatchSet& patches) const {
  const auto forecast = forecast_light(patches, *tracer_, settings_.light, context_);
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
  reporter_.say("method", text);
}

std::optional<double> LightStage::error_target() const {
  return settings_.light.method == Method::sampled ? std::optional(settings_.light.sampled.error)
                                                   : std::nullopt;
}

bool LightStage::ended_by_ray_budget(const SolveReport& solved) const {
  return solved.stop == StopReason::ray_limit && settings_.light.sampled.ray_budget > 0;
}

bool LightStage::fell_short(const SolveReport& solved) const {
  const bool is_at_limit = (solved.stop == StopReason::ray_limit && !ended_by_ray_budget(solved)) ||
                           solved.stop == StopReason::time_limit;
  return solved.stop == StopReason::stopped_by_user || (is_at_limit && error_target().value_or(0.0) > 0.0);
}

// Reports lux of the sky and lumens of the lamps, which reveals a wrong unit, and lamps that light nothing.
void LightStage::report_lamps(const PatchSet& patches, const std::vector<LampView>& views) const {
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
    reporter_.say("sky",
                  fmt::format("{} lx in the open", rounded(colours.lumens(patches.open_irradiance()))));
  if (!lamps.empty()) reporter_.say("light", lamps);
  for (const auto& view : views) {
    const auto warning = lamp_warning(patches, view);
    if (!warning.text.empty()) warn(reporter_.log(), warning.text, warning.hints);
  }
}

void LightStage::report_losses(const Baked& baked, const SolveReport& solved) const {
  const auto& energy = solved.energy;
  auto power = std::accumulate(energy.emitted.begin(), energy.emitted.end(), 0.0);
  power = std::accumulate(energy.from_sky.begin(), energy.from_sky.end(), power);
  for (std::size_t m = 0; m < solved.back_loss.size(); ++m)
    if (power > 0.0 && solved.back_loss[m] > 0.001 * power)
      warn(reporter_.log(),
           fmt::format(
               "{:.1f} % of the power of lamps and sky is lost at the backs of one-sided material '{}'",
               100.0 * solved.back_loss[m] / power, baked.patches.materials[m].name));
}

}  // namespace luxel
