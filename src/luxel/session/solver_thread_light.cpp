// SPDX-License-Identifier: Apache-2.0
// Turns the solutions of a session into the lights that it publishes: smoothed, relit, bounce by bounce.
#include <algorithm>
#include <utility>

#include "luxel/core/error.h"
#include "luxel/session/relit_patches.h"
#include "luxel/session/solver_thread.h"
#include "luxel/solution/sample_state.h"

namespace luxel {

SessionLight SolverThread::light_of(SessionMesh mesh, Solution solution) const {
  SessionLight light;
  light.mesh = std::move(mesh);
  light.solution = std::move(solution);
  light.samples = relighting_.samples();
  light.sampled = relighting_.options();
  light.step = solve_.step;
  const auto& last = own_.shown;
  const bool is_same = last && last->mesh.geometry == light.mesh.geometry &&
                       last->solution.irradiance.front == light.solution.irradiance.front &&
                       last->solution.irradiance.back == light.solution.irradiance.back;
  light.smooth = is_same || is_closing()
                     ? (last ? last->smooth : nullptr)
                     : std::make_shared<const SmoothLight>(make_smooth_light(
                           *light.mesh.patches, light.solution, settings_.smooth, context_));
  return light;
}

std::shared_ptr<const SessionLight> SolverThread::publish_light(SessionLight light) {
  light.number = state_.light ? state_.light->number + 1 : 1;
  state_.light = std::make_shared<const SessionLight>(std::move(light));
  state_.status.can_relight = state_.light->samples != nullptr;
  publish();
  channels_.to_background.push(SolverPublished{});
  return state_.light;
}

// Lights that come faster than they can be shown are dropped, except the last one, and except while a person
// waits for each.
void SolverThread::show(Solution solution, bool is_last) {
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  if (!is_last && !pending_.is_stepping && begin - solve_.shown < 2 * solve_.cost_of_showing) return;
  auto light = light_of(solve_.mesh, std::move(solution));
  light.is_last = is_last;
  light.is_relit = solve_.mesh.patches != mesh_.patches;
  light.unshot = solve_.unshot.values();
  const auto shown = publish_light(std::move(light));
  own_ = {std::nullopt, shown->is_relit ? nullptr : shown};
  solve_.shown = Clock::now();
  solve_.cost_of_showing = solve_.shown - begin;
}

void SolverThread::find_group_light() {
  const auto& samples = relighting_.samples();
  if (!samples || !samples->gathered.empty() || !settings_.stores_transport) return;
  publish_stage("light groups");
  relighting_.find_group_light([this](const Progress& progress) {
    take_commands();
    state_.status.done = progress.done;
    publish();
    return is_closing() || pending_.solve || pending_.error ? Next::stop : Next::go_on;
  });
}

void SolverThread::take_lighting() {
  if (const auto lighting = std::exchange(pending_.lighting, {})) attempt([&] { relight(*lighting); });
}

void SolverThread::relight(const Lighting& lighting) {
  const bool is_other = lighting_ != lighting;
  lighting_ = lighting;
  if (!mesh_.tracer) throw InputError(file_.string(), "it could not be opened, so there is nothing to light");
  if (!relighting_.has_samples()) {
    if (is_other && !pending_.solve) pending_.solve = command::Solve{light_};
    return;
  }
  if (lighting == Lighting{}) return show_own_light();
  find_group_light();
  if (is_closing()) return;
  publish_stage("relight");
  auto relit = relighting_.relight(lighting);
  auto mesh = mesh_;
  mesh.patches = std::move(relit.patches);
  auto light = light_of(std::move(mesh), std::move(relit.solution));
  describe_relit(light.solution, lighting);
  light.is_relit = true;
  light.is_last = !solve_.is_running;
  publish_light(std::move(light));
}

void SolverThread::show_own_light() {
  if (own_.shown) {
    publish_light(*own_.shown);
  } else if (own_.hidden) {
    solve_.shown = {};  // so that it is not dropped, however early it comes
    show(*own_.hidden, !solve_.is_running);
  }
}

// Copies the provenance of the original light, and adds the changes.
void SolverThread::describe_relit(Solution& relit, const Lighting& lighting) const {
  const auto& own = own_.shown ? own_.shown->solution : *own_.hidden;
  auto provenance = own.provenance;
  provenance.rays = relit.provenance.rays;
  provenance.scene_fingerprint = relit.provenance.scene_fingerprint;
  describe_lighting(*mesh_.patches, lighting, provenance);
  relit.provenance = std::move(provenance);
  relit.mesh_error = own.mesh_error;
  relit.stop = own.stop;
}

void SolverThread::show_bounces(std::optional<int> count) {
  if (!count) return relight(lighting_);
  if (!relighting_.has_samples() || !mesh_.tracer)
    throw InputError(file_.string(), "its light keeps no samples to bounce: solve it by the method sampled");
  publish_stage("bounces");
  auto after = relighting_.after_bounces(std::max(0, *count));
  auto light = light_of(mesh_, std::move(after.solution));
  light.bounces = std::max(0, *count);
  light.is_last = true;
  light.unshot = std::move(after.unshot);
  publish_light(std::move(light));
}

}  // namespace luxel
